// Shapes of things by name: which maker, what is usual for its size, three levels of detail.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/model/thing_params.h"
#include "seamount/model/things.h"

namespace seamount::geom {

/// What is usual for a form.
struct UsualThing {
  double height_m = 1.0;
  double slimness = 1.0;  ///< height over width
  double lean = 0.0;      ///< how far it stands along the ground's normal
  double sunk = 0.02;     ///< part of its height that is in the ground
  double foot = 0.3;      ///< radius of what touches the ground, over its width
};
UsualThing usual(ThingForm form);

/// Height and width of a thing of size 1, metres.
struct ThingSize {
  double height_m, width_m;
};
ThingSize size_of(const ThingParams& params);

/// One mesh. `variant` in [0, variants); health 1 is whole; level 0, 1 or 2. Its box around the z axis has the size of
/// `params` (less where parts are missing), its lowest point is at z = 0. About 0.2 ms. REQUIRES: not ThingForm::file.
ThingMesh make_thing_mesh(const ThingParams& params, Seed seed, int variant, double health, int level);

/// All levels of one, named `name` and what sets it apart.
ThingShape make_thing_shape(const ThingParams& params, const std::string& name, Seed seed, int variant, double health);

/// A mesh of the user's, stretched to the size that is asked for, with two coarser levels by clustering; ailing: paler.
/// Throws InvalidArgument{"mesh"} if it has no triangles or no extent.
ThingShape shape_of_mesh(const ThingMesh& mesh, const ThingParams& params, const std::string& name, double health);

}  // namespace seamount::geom

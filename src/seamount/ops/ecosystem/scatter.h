// ecosystem.scatter: things of one kind spread over a terrain, at drawn places or by a density: a grove, a boulder
// field. No rules of life: those are a scene's.
#pragma once

#include <memory>
#include <string>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/thing_params.h"
#include "seamount/model/things.h"

namespace seamount::ecosystem {

struct ScatterParams {
  ThingParams thing;
  double spacing_m = 50.0;
  double min_height_m = -12000.0;
  double max_height_m = 9000.0;
  double max_slope_deg = 90.0;
  double health = 1.0;
  int max_triangles = 0;
  bool keep_ground = true;

  static constexpr auto fields() {
    using P = ScatterParams;
    return std::tuple(
        field(&P::thing, "thing", "what it is"),
        field(&P::spacing_m, "spacing_m", "m", between(0.01, 100000), "least distance of two, without drawn places"),
        field(&P::min_height_m, "min_height_m", "m", between(-12000, 9000), "none on lower ground"),
        field(&P::max_height_m, "max_height_m", "m", between(-12000, 9000), "none on higher ground"),
        field(&P::max_slope_deg, "max_slope_deg", "deg", between(0, 90), "none on steeper ground"),
        field(&P::health, "health", "", between(0, 1), "1 is whole; ailing things are paler and have less of all"),
        field(&P::max_triangles, "max_triangles", "", between(0, 1000000000),
              "of all together: things get coarser, then fewer; 0: no limit"),
        field(&P::keep_ground, "keep_ground", "what they stand on goes with them into files"));
  }
};

struct ScatterInputs {
  const HeightField& terrain;
  const ScalarField* density = nullptr;        ///< share of the places that are taken, [0, 1]; same frame
  const Drawing* places = nullptr;             ///< its points: one there each; else its areas: within them
  const Things* others = nullptr;              ///< come along, first
  std::shared_ptr<const ThingMesh> mesh = {};  ///< of thing.file
};

/// Throws InvalidArgument for params out of range, more than a million things, and as place_things();
/// IncompatibleInputs for a density of another size. Parallel; about 1 us a thing.
Things scatter(const ScatterInputs& inputs, const ScatterParams& params, Seed seed, const RunContext& run);

/// Both; shapes of the second are numbered on. The ground is the first's, else the second's.
Things joined(Things first, const Things& second);

}  // namespace seamount::ecosystem

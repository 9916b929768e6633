// Any quantity of a scene as a raster: a material, the current, a distance, a fitness.
#pragma once

#include <string>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

struct FieldParams {
  std::string of;
  std::string fitness_of;
  int window = 0;

  static constexpr auto fields() {
    return std::tuple(
        field(&FieldParams::of, "of", "an expression as in catalogues: a material, current, distance(reef), ..."),
        field(&FieldParams::fitness_of, "fitness_of", "a class instead: where it would be born, as its fitness says"),
        field(&FieldParams::window, "window", "", at_least(0),
              "of the scene: 0 its own frame, else a window, counted from 1"));
  }
};

/// The value of an expression at every cell of the scene's frame or of a window, as the scene stands; NaN where it has
/// none. Throws InvalidArgument for an expression that does not parse (with its column), an unknown class or window;
/// IncompatibleInputs. As long as an iteration of growth, and 50 ns a cell and word.
ScalarField field_of(const Scene& scene, const Site& site, const FieldParams& params, const RunContext& run);

struct HeightParams {
  int window = 0;

  static constexpr auto fields() {
    return std::tuple(field(&HeightParams::window, "window", "", at_least(0),
                            "of the scene: 0 its own frame, else a window, counted from 1"));
  }
};

/// The ground with what objects and events make of it (P3 eq. 1.46-1.49), metres over z = 0, and the current over it.
struct GroundAndCurrent {
  HeightField terrain;
  VectorField current;
};
GroundAndCurrent height(const Scene& scene, const Site& site, const HeightParams& params, const RunContext& run);

}  // namespace seamount::ecosystem

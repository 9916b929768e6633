// terrain.blend: two terrains become one, everywhere or where a mask says so.
//
// What is done to the first terrain: mix (the second takes its place), max and min (whichever is higher or lower, with
// a crease rounded over smooth_m: geom/scalar/blend.h), add and subtract (the second is a relief to put on or carve
// out). The result is a + w (op(a, b) - a) with w = strength times the mask, so that a weight of 0 leaves the first
// terrain as it is, to the bit. Where one of the two has no height (NaN) the other stands; add and subtract have none.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::terrain {

enum class BlendMode { mix, max, min, add, subtract };

struct BlendParams {
  BlendMode mode = BlendMode::mix;
  double strength = 1.0;
  double smooth_m = 5.0;

  static constexpr auto fields() {
    using P = BlendParams;
    return std::tuple(
        field(
            &P::mode, "mode",
            "mix: the second in place of the first; max, min: the higher, the lower; add, subtract: the second put on "
            "or carved out"),
        field(&P::strength, "strength", "", between(0, 1), "how much of it is done; a mask is multiplied with it"),
        field(&P::smooth_m, "smooth_m", "m", between(0, 1000),
              "max and min: how far the rounded result lies beyond both where they are equal; 0: a sharp crease"));
  }
};

/// The blend, on a's frame. `mask` may be null: everywhere; values beyond [0, 1] count as the nearer end. Throws
/// InvalidArgument for params out of range, IncompatibleInputs for b or mask of another size and for b with other
/// cells. Parallel, vectorised; about 3 ns per cell.
HeightField blend(const HeightField& a, const HeightField& b, const Mask* mask, const BlendParams& params,
                  const RunContext& run);

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::BlendMode> {
  static constexpr std::array<std::string_view, 5> names = {"mix", "max", "min", "add", "subtract"};
};

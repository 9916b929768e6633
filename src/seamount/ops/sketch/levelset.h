// sketch.levelset: the high part of a terrain as an area, the other way to sketch (P1 sec. 5.2, fig. 9): blur, and keep
// what lies above a percentile of the heights.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"

namespace seamount::sketch {

struct LevelsetParams {
  double percentile = 60.0;
  std::optional<double> blur_m;

  static constexpr auto fields() {
    using P = LevelsetParams;
    return std::tuple(field(&P::percentile, "percentile", "%", between(0, 100),
                            "share of the terrain that lies lower than the levelset"),
                      field(&P::blur_m, "blur_m", "m", between(0, 1e6),
                            "deviation of the blur before it; a 64th of the terrain's longer side if absent"));
  }
};

struct Levelset {
  Mask mask;       ///< 1 inside, 0 outside
  Image image;     ///< white inside, black outside
  Drawing areas;   ///< "levelset", with level_m
  double level_m;  ///< the height at the percentile, of the blurred terrain
};

/// Throws InvalidArgument for params out of range. Parallel but for finding the percentile; 12 bytes per cell.
Levelset levelset(const HeightField& terrain, const LevelsetParams& params, const RunContext& run);

}  // namespace seamount::sketch

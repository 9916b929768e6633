// sketch.levelset: the high part of a terrain as an area, the other way to sketch (P1 sec. 5.2, fig. 9): blur, and keep
// what lies above a percentile of the heights. Ours: land is blurred with land alone and the percentile is one of land,
// as for sketch.extract, so that an island in a deep sea has a levelset of its own and not one of the sea floor.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"

namespace seamount::sketch {

struct LevelsetParams {
  double percentile = 60.0;
  std::optional<double> blur_m;
  bool sea = true;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = LevelsetParams;
    return std::tuple(
        field(&P::percentile, "percentile", "%", between(0, 100),
              "share of the land that lies lower than the levelset"),
        field(&P::blur_m, "blur_m", "m", between(0, 1e6),
              "deviation of the blur before it; a 64th of the terrain's longer side if absent"),
        field(&P::sea, "sea", "only what lies above sea level counts; otherwise the sea floor is ground as well"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }
};

struct Levelset {
  Mask mask;       ///< 1 inside, 0 outside and in the sea
  Image image;     ///< white inside, black outside
  Drawing areas;   ///< "levelset", with level_m
  double level_m;  ///< the height at the percentile, of the blurred land; 0 where there is none, which is said
};

/// Unknown cells (NaN) are not drawn on; water leaves there. Throws InvalidArgument for params out of range. Parallel
/// but for finding the percentile; 24 bytes per cell.
Levelset levelset(const HeightField& terrain, const LevelsetParams& params, const RunContext& run);

}  // namespace seamount::sketch

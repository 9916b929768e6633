#include "seamount/ops/hydrology/lakes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/text.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/lake_levels.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/hydrology/lake_areas.h"
#include "seamount/ops/hydrology/mostly_sea.h"

namespace seamount::hydrology {
namespace {

constexpr double kSecondsPerYear = 365.25 * 86400.0;

void check_runoff(const ScalarField* runoff, const GridFrame& frame) {
  if (runoff == nullptr) return;
  check_same_size("runoff", runoff->frame(), frame);
  for (const float value : runoff->cells())
    if (!(value >= 0.0F) || std::isinf(value))
      throw InvalidArgument("runoff", format_number(static_cast<double>(value)) + " mm/yr is no amount of water");
}

Drawing draw(const geom::LakeLevels& levels, const ScalarField& depth, double min_lake_m2, const RunContext& run) {
  const GridFrame& frame = depth.frame();
  std::vector<LakeArea> areas(levels.lakes.size());
  for (size_t i = 0; i < depth.size(); ++i) {
    const int32_t lake = levels.lake.data()[i];
    if (lake < 0) continue;
    LakeArea& area = areas[static_cast<size_t>(lake)];
    area.cells.push_back(static_cast<int32_t>(i));
    area.depth_m = std::max(area.depth_m, static_cast<double>(depth.data()[i]));
    area.volume_m += static_cast<double>(depth.data()[i]);
  }
  for (size_t i = 0; i < areas.size(); ++i) {
    const geom::StandingLake& lake = levels.lakes[i];
    areas[i].level_m = static_cast<double>(lake.level_m);
    areas[i].more = {{"closed", lake.closed ? 1.0 : 0.0},
                     {"inflow_m3_s", lake.inflow / kSecondsPerYear},
                     {"outflow_m3_s", lake.outflow / kSecondsPerYear}};
  }
  std::erase_if(areas, [&](const LakeArea& area) {
    return area.cells.empty() || static_cast<double>(area.cells.size()) * frame.cell_m * frame.cell_m < min_lake_m2;
  });
  return draw_lakes(std::move(areas), frame, run);
}

}  // namespace

Lakes lakes(const HeightField& terrain, const ScalarField* runoff, const LakesParams& params, const RunContext& run) {
  check_params(params);
  check_runoff(runoff, terrain.frame());
  say_mostly_sea(terrain, params.sea, run);
  float sea = params.sea ? 0.0F : geom::kNoSea;
  const HeightField open = geom::lower_sea(terrain, sea, params.min_sea_m2, run);
  const HeightField ground =
      geom::fill_shallow_depressions(open, sea, static_cast<float>(params.min_depth_m), run.part(0.0, 0.4));
  const geom::LakeLevels levels = geom::lake_levels(ground, sea,
                                                    {.runoff_mm_yr = params.runoff_mm_yr,
                                                     .runoff_map = runoff,
                                                     .loss_mm_yr = params.evaporation_mm_yr - params.rain_mm_yr},
                                                    run.part(0.4, 0.9));
  Lakes out{terrain, ScalarField(terrain.frame(), 0.0F), ScalarField(terrain.frame(), 0.0F), {}};
  for (size_t i = 0; i < terrain.size(); ++i) {
    if (const int32_t number = levels.lake.data()[i]; number >= 0) {
      const geom::StandingLake& lake = levels.lakes[static_cast<size_t>(number)];
      out.surface.data()[i] = lake.level_m;
      out.depth_m.data()[i] = lake.level_m - terrain.data()[i];
      out.sinks.data()[i] = lake.closed ? 1.0F : 0.0F;
    }
    if (std::isnan(terrain.data()[i]))
      out.depth_m.data()[i] = out.sinks.data()[i] = std::numeric_limits<float>::quiet_NaN();
  }
  for (const geom::StandingLake& lake : levels.lakes)
    if (lake.closed) out.sinks.data()[lake.pit] = 1.0F;
  out.lakes = draw(levels, out.depth_m, params.min_lake_m2, run.part(0.9, 1.0));
  if (out.lakes.areas.empty()) run.say("no lake: no depression of min_depth_m keeps min_lake_m2 wet");
  return out;
}

}  // namespace seamount::hydrology

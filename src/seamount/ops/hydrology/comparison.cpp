#include "seamount/ops/hydrology/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::hydrology {

double comparison_cell(const std::vector<GridFrame>& frames, std::optional<double> wanted_m) {
  constexpr double kRounding = 1e-9;
  double coarsest = 0.0;
  for (const GridFrame& frame : frames) coarsest = std::max(coarsest, frame.cell_m);
  if (!wanted_m) return coarsest;
  if (*wanted_m < coarsest * (1.0 - kRounding))
    throw InvalidArgument("cell_m", format_number(*wanted_m) + " is finer than the cells of " +
                                        (frames.size() > 1 ? "the coarser input, " : "the input, ") +
                                        format_number(coarsest) + " m");
  return *wanted_m;
}

GridFrame frame_at(const GridFrame& frame, double cell_m) {
  constexpr double kSame = 1e-9;
  GridFrame out = frame;
  if (std::abs(frame.cell_m / cell_m - 1.0) >= kSame) {
    out.width = std::max(1, static_cast<int>(std::lround(frame.width_m() / cell_m)));
    out.height = std::max(1, static_cast<int>(std::lround(frame.height_m() / cell_m)));
    out.cell_m = cell_m;
  }
  const int64_t walled = (int64_t{out.width} + 2) * (int64_t{out.height} + 2),
                most = std::numeric_limits<int32_t>::max();
  if (walled > most)
    throw InvalidArgument("cell_m", format_number(cell_m) + " makes " + std::to_string(out.width) + " x " +
                                        std::to_string(out.height) + " cells; at most " + std::to_string(most) +
                                        " with one more on each side");
  return out;
}

SurveyPlan make_plan(const std::vector<Land>& lands, float sea_level_m, double relief_window_m,
                     std::optional<double> channel_m2, std::optional<double> min_prominence_m) {
  constexpr double kChannelPart = 2000.0, kProminencePart = 50.0, kMinProminence = 1e-3;
  double land_m2 = std::numeric_limits<double>::infinity(), map_m2 = land_m2, relief = 0.0;
  for (const Land& land : lands) {
    map_m2 = std::min(map_m2, static_cast<double>(land.of_cells) * land.cell_m2);
    if (land.cells == 0) continue;
    land_m2 = std::min(land_m2, static_cast<double>(land.cells) * land.cell_m2);
    relief = static_cast<double>(land.high_m) - static_cast<double>(land.low_m);  // the reference comes last
  }
  SurveyPlan plan;
  plan.sea_level_m = sea_level_m;
  plan.relief_window_m = relief_window_m;
  plan.channel_m2 = channel_m2.value_or(std::min(land_m2, map_m2) / kChannelPart);
  plan.min_prominence_m = min_prominence_m.value_or(std::max(kMinProminence, relief / kProminencePart));
  return plan;
}

}  // namespace seamount::hydrology

#include "seamount/ops/erosion/slopes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/erosion/beds.h"
#include "seamount/ops/erosion/slides.h"

namespace seamount::erosion {
namespace {

constexpr double kSlideTime_yr = 50.0;  // in which an excess slides down
constexpr double kSlidePerRound = 0.5;  // of what would level it; more makes ripples
constexpr float kCover_m = 0.5F;        // of debris halves weathering

double slope_of(double angle_deg) { return std::tan(angle_deg * std::numbers::pi / 180.0); }

/// Calls f(neighbour, direction) for the neighbours of a cell.
template <class F>
SEAMOUNT_INLINE void for_neighbours(const GridFrame& frame, int x, int y, F f) {
  for (int d = 0; d < 8; ++d) {
    const int nx = x + geom::kFlowDx[d], ny = y + geom::kFlowDy[d];
    if (nx < 0 || ny < 0 || nx >= frame.width || ny >= frame.height) continue;
    f(static_cast<size_t>(ny) * frame.width + nx, d);
  }
}

/// Calls f(cell, x, y) for every cell, in parallel rows.
template <class F>
void for_cells(const GridFrame& frame, const RunContext& run, F f) {
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) f(static_cast<size_t>(y) * frame.width + x, x, y);
    }
  });
}

/// Bedrock turns to debris where it is steep and bare; the surface stays.
void weather(Layers& ground, const Maps& site, const Slopes& slopes, const RunContext& run) {
  const auto depth = static_cast<float>(slopes.weathering_m_yr * slopes.years);
  const auto steep = static_cast<float>(1.0 / (2.0 * ground.surface.cell_m() * slope_of(slopes.debris_angle_deg)));
  const HeightField& z = ground.surface;
  for_cells(ground.frame(), run, [&](size_t cell, int x, int y) {
    const float dx = (z.clamped(x + 1, y) - z.clamped(x - 1, y)) * steep;
    const float dy = (z.clamped(x, y + 1) - z.clamped(x, y - 1)) * steep;
    const float bare = kCover_m / (kCover_m + ground.debris.data()[cell] + ground.sediment.data()[cell]);
    ground.debris.data()[cell] += depth * std::min(1.0F, dx * dx + dy * dy) * bare * value_or_one(site.mask, cell) /
                                  bedrock_hardness(ground, site, cell);
  });
}

}  // namespace

void run_slopes(Layers& ground, const Maps& site, const Slopes& slopes, ScalarField& share, ScalarField& next,
                const RunContext& run) {
  if (slopes.weathering_m_yr > 0) weather(ground, site, slopes, run);
  const double speed = kSlidePerRound * std::min(1.0, slopes.years / kSlideTime_yr);
  for (int k = 0; k < slopes.slides; ++k) {
    if (site.beds == nullptr)  // each bed stands as steep as it can (repose.h), which differs from the angle
      slide(ground.surface, ground.debris, Sliding::bedrock_below, site, slopes.bedrock_angle_deg, speed, share, next,
            run);
    slide(ground.surface, ground.debris, Sliding::layer, site, slopes.debris_angle_deg, speed, share, next, run);
    slide(ground.surface, ground.sediment, Sliding::layer, site, slopes.sediment_angle_deg, speed, share, next, run);
  }
}

}  // namespace seamount::erosion

#include "seamount/ops/terrain/sea_floor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/solve/poisson.h"
#include "seamount/geom/water/flat_sea.h"

namespace seamount::terrain {
namespace {

/// Cells a side of the grid on which slopes are spread: they change slowly.
constexpr int kSpreadSide = 512;

/// Rise over run of the land that the nearest coast belongs to, everywhere: given on a strip of land, spread over the
/// rest.
ScalarField slope_at_coast(const HeightField& terrain, const ScalarField& from_sea, const SeaFloorParams& params,
                           const RunContext& run) {
  const GridFrame& own = terrain.frame();
  GridFrame coarse = own;
  const int size = (std::max(own.width, own.height) + kSpreadSide - 1) / kSpreadSide;
  const auto shore = static_cast<int>(std::min(1e6, 0.5 * params.shore_m / own.cell_m));
  const int factor = std::clamp(std::max(size, shore), 1, std::max(1, std::min(own.width, own.height) / 4));
  coarse.width = (own.width + factor - 1) / factor;
  coarse.height = (own.height + factor - 1) / factor;
  coarse.cell_m *= factor;
  const auto least = static_cast<float>(std::tan(params.min_slope_deg * std::numbers::pi / 180));
  ScalarField slope(coarse, least);
  Grid<uint8_t> known(coarse, 0);
  for (int y = 0; y < coarse.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < coarse.width; ++x) {
      double sum = 0;
      int count = 0;
      for (int j = y * factor; j < std::min((y + 1) * factor, own.height); ++j) {
        for (int i = x * factor; i < std::min((x + 1) * factor, own.width); ++i) {
          const float inland = from_sea(i, j) - static_cast<float>(0.5 * own.cell_m);
          if (!(inland > 0 && inland <= params.shore_m && terrain(i, j) > 0)) continue;
          sum += static_cast<double>(terrain(i, j) / inland);
          ++count;
        }
      }
      if (count == 0) continue;
      slope(x, y) = std::max(least, static_cast<float>(params.steepness * sum / count));
      known(x, y) = 1;
    }
  }
  geom::solve_laplace(slope, known, run);
  for (float& s : slope.cells()) s = std::max(s, least);
  return slope;
}

}  // namespace

HeightField sea_floor(const HeightField& terrain, const SeaFloorParams& params, const RunContext& run) {
  check_params(params);
  const Grid<uint8_t> sea = geom::flat_sea_to_coast(terrain, run.part(0.0, 0.1));
  if (sea.empty()) {
    run.say("less than a hundredth of the terrain is a level sea at 0 m: there is nothing to give a floor");
    return terrain;
  }
  Grid<uint8_t> land(sea.frame());
  for (size_t i = 0; i < sea.size(); ++i) land.cells()[i] = sea.cells()[i] == 0 ? 1 : 0;
  const ScalarField from_land = geom::distance_to(land, run.part(0.1, 0.3));
  const ScalarField from_sea = geom::distance_to(sea, run.part(0.3, 0.5));
  const ScalarField slope = slope_at_coast(terrain, from_sea, params, run.part(0.5, 0.8));
  HeightField out = terrain;
  const GridFrame& frame = terrain.frame();
  const auto depth = static_cast<float>(params.depth_m);
  const auto half = static_cast<float>(0.5 * frame.cell_m);
  parallel_rows(run.part(0.8, 1.0), frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const double row = slope.frame().row(frame.y(y));
      for (int x = 0; x < frame.width; ++x) {
        if (sea(x, y) == 0) continue;
        const float away = std::isfinite(from_land(x, y)) ? from_land(x, y) - half : 1e9F;
        const float s = geom::sample_bilinear(slope, slope.frame().column(frame.x(x)), row);
        out(x, y) = -depth * (1.0F - std::exp(-s * std::max(away, half) / depth));
      }
    }
  });
  return out;
}

}  // namespace seamount::terrain

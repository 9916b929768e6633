// What the words of erosion.run promise, on three terrains.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/erosion/run.h"

namespace seamount::erosion {
namespace {

RunParams of(std::string_view name) {
  RunParams params;
  for (const auto& row : RunParams::presets())
    if (row.name == name) row.set(params);
  return params;
}

struct Look {
  double relief_m;  ///< between the lowest and the highest twentieth
  double slope;     ///< mean
  double steep;     ///< that a twentieth exceeds
  double covered;   ///< share of the ground under more than half a metre of debris or sediment
};

Look look(std::string_view preset, uint64_t seed) {
  const GridFrame frame = GridFrame::centred(128, 128, 80);
  HeightField z = geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 6000, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : z.cells()) value = 700 + 900 * value;
  const Eroded result = run({z, {}, {}}, {}, of(preset), Seed{seed}, {});
  std::vector<double> heights, slopes;
  double covered = 0;
  for (int y = 1; y < z.height(); ++y) {
    for (int x = 1; x < z.width(); ++x) {
      const HeightField& t = result.terrain;
      heights.push_back(t(x, y));
      slopes.push_back(std::hypot(t(x, y) - t(x - 1, y), t(x, y) - t(x, y - 1)) / frame.cell_m);
      covered += result.debris(x, y) + result.sediment(x, y) > 0.5F ? 1 : 0;
    }
  }
  std::sort(heights.begin(), heights.end());
  std::sort(slopes.begin(), slopes.end());
  const size_t n = slopes.size();
  double sum = 0;
  for (const double slope : slopes) sum += slope;
  return {heights[n * 19 / 20] - heights[n / 20], sum / static_cast<double>(n), slopes[n * 19 / 20],
          covered / static_cast<double>(n)};
}

TEST(ErosionPresets, AgeTakesHeightAndRoundsAndTheDesertIsSteepOverDebris) {
  for (const uint64_t seed : {1, 2, 3}) {
    const Look young = look("young", seed), mature = look("mature", seed), old = look("old", seed),
               desert = look("desert", seed);
    EXPECT_GT(young.relief_m, mature.relief_m) << seed;
    EXPECT_GT(mature.relief_m, 1.25 * old.relief_m) << seed;
    EXPECT_GT(young.slope, 2 * old.slope) << seed;
    EXPECT_GT(mature.steep, 1.5 * old.steep) << seed;
    EXPECT_GT(desert.steep, 1.5 * old.steep) << seed;
    EXPECT_GT(desert.covered, young.covered) << seed;
    EXPECT_GT(desert.covered, mature.covered) << seed;
    if (HasFailure())
      ADD_FAILURE() << young.relief_m << " " << mature.relief_m << " " << old.relief_m << "; " << young.slope << " "
                    << old.slope << "; " << young.steep << " " << mature.steep << " " << old.steep << " "
                    << desert.steep << "; " << young.covered << " " << mature.covered << " " << desert.covered;
  }
}

}  // namespace
}  // namespace seamount::erosion

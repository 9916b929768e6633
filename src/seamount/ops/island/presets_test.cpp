// What the words of island.build promise, on random islands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "seamount/ops/island/choose_plan.h"

namespace seamount::island {
namespace {

struct Look {
  double peak_m = 0;
  double slope = 0;   ///< mean of the land above the beach
  double lagoon = 0;  ///< ground at most 20 m under water, as a share of the land
};

Look look(std::string_view preset, uint64_t seed) {
  BuildParams params;
  for (const auto& row : BuildParams::presets())
    if (row.name == preset) row.set(params);
  const GridFrame frame = GridFrame::centred(161, 161, 100);
  const HeightField z = build(BuildInputs{}, params, frame, Seed{seed}, {}).terrain;
  Look out;
  double land = 0, hills = 0, shallow = 0;
  for (int y = 1; y < z.height(); ++y) {
    for (int x = 1; x < z.width(); ++x) {
      out.peak_m = std::max(out.peak_m, static_cast<double>(z(x, y)));
      if (z(x, y) > 0) ++land;
      if (z(x, y) <= 0 && z(x, y) > -20) ++shallow;
      if (z(x, y) < 20) continue;
      ++hills;
      out.slope += std::hypot(z(x, y) - z(x - 1, y), z(x, y) - z(x, y - 1)) / frame.cell_m;
    }
  }
  out.slope /= hills;
  out.lagoon = shallow / land;
  return out;
}

TEST(IslandPresets, ShieldsAreSmoothHighIslandsSteepAndOldOnesLowInWideLagoons) {
  for (const uint64_t seed : {1, 2, 3}) {
    const Look hotspot = look("hotspot", seed), high = look("high", seed), old = look("old", seed);
    EXPECT_GT(high.peak_m, hotspot.peak_m) << seed;
    EXPECT_GT(hotspot.peak_m, old.peak_m) << seed;
    EXPECT_GT(high.slope, 2 * hotspot.slope) << seed;
    EXPECT_GT(high.slope, 2 * old.slope) << seed;
    EXPECT_GT(old.lagoon, 2 * high.lagoon) << seed;
    EXPECT_GT(high.lagoon, 2 * hotspot.lagoon) << seed;
    if (HasFailure())
      ADD_FAILURE() << hotspot.slope << " " << high.slope << " " << old.slope << "; " << hotspot.lagoon << " "
                    << high.lagoon << " " << old.lagoon;
  }
}

}  // namespace
}  // namespace seamount::island

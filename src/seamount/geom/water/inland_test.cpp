#include "seamount/geom/water/inland.h"

#include <gtest/gtest.h>

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

/// Waters by walking from cell to cell.
HeightField raised_plainly(HeightField z, float sea, int64_t least) {
  std::vector<bool> seen(z.size());
  for (int32_t first = 0; first < static_cast<int32_t>(z.size()); ++first) {
    if (seen[static_cast<size_t>(first)] || z.data()[first] > sea) continue;
    std::vector<int32_t> water(1, first);
    seen[static_cast<size_t>(first)] = true;
    bool edge = false;
    for (size_t next = 0; next < water.size(); ++next) {
      const int x = water[next] % z.width(), y = water[next] / z.width();
      edge = edge || x == 0 || y == 0 || x == z.width() - 1 || y == z.height() - 1;
      for (size_t d = 0; d < 8; ++d) {
        const int nx = x + kFlowDx[d], ny = y + kFlowDy[d];
        if (!z.contains(nx, ny) || z(nx, ny) > sea) continue;
        const int32_t other = ny * z.width() + nx;
        if (seen[static_cast<size_t>(other)]) continue;
        seen[static_cast<size_t>(other)] = true;
        water.push_back(other);
      }
    }
    if (edge || static_cast<int64_t>(water.size()) >= least) continue;
    for (const int32_t cell : water) z.data()[cell] = std::nextafter(sea, INFINITY);
  }
  return z;
}

TEST(Inland, RaisesEnclosedWaterThatIsSmall) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Rng rng(Seed{seed});
    const int width = rng.integer(1, 24), height = rng.integer(1, 24);
    HeightField z(GridFrame::centred(width, height, 10));
    const double wet = rng.uniform(0.1, 0.7);
    for (float& value : z.cells()) value = static_cast<float>(rng.chance(wet) ? -rng.uniform() : rng.uniform());
    const int least = rng.integer(1, 12);
    EXPECT_EQ(raise_inland(z, 0.0F, 100.0 * least, {}), raised_plainly(z, 0.0F, least)) << seed;
  }
}

TEST(Inland, WithoutASeaNothingChanges) {
  const HeightField z(GridFrame::centred(9, 9, 10), -4.0F);
  EXPECT_EQ(raise_inland(z, kNoSea, {}, {}), z);
  EXPECT_EQ(raise_inland(z, 0.0F, {}, {}), z);  // all of it reaches the edge
}

}  // namespace
}  // namespace seamount::geom

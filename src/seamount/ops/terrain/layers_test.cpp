#include "seamount/ops/terrain/layers.h"

#include <gtest/gtest.h>

namespace seamount::terrain {
namespace {

TEST(TerrainLayers, AreThePapersOnHeightsFromZeroToOne) {
  HeightField terrain(GridFrame::centred(101, 1, 10.0));
  for (int x = 0; x <= 100; ++x) terrain(x, 0) = static_cast<float>(x) / 100.0F;
  const geom::Layers out = layers(terrain, {.smooth = false, .variation = 0}, {});
  for (int x = 0; x <= 100; ++x) {
    const geom::LayerShares s = geom::layer_shares(terrain(x, 0), {0.3, 0.1, 0.5, 0.05});
    ASSERT_NEAR(out.low(x, 0), s.low, 1e-5);
    ASSERT_NEAR(out.middle(x, 0), s.middle, 1e-5);
    ASSERT_NEAR(out.high(x, 0), s.high, 1e-5);
  }
}

TEST(TerrainLayers, RefusesBordersInTheWrongOrderAndAnEmptyTerrain) {
  const HeightField terrain(GridFrame::centred(4, 4, 10.0), 5.0F);
  EXPECT_THROW(layers(terrain, {.low_m = 50, .high_m = 40}, {}), InvalidArgument);
  EXPECT_THROW(layers(terrain, {.variation = 2}, {}), InvalidArgument);
  EXPECT_THROW(layers(HeightField(), {}, {}), InvalidArgument);
  EXPECT_EQ(layers(terrain, {}, {}).low(1, 1), 1.0F);  // a plain is all low
}

}  // namespace
}  // namespace seamount::terrain

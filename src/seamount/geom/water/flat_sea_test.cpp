#include "seamount/geom/water/flat_sea.h"

#include <gtest/gtest.h>

namespace seamount::geom {
namespace {

TEST(FlatSea, IsWhatIsZeroAllAround) {
  HeightField terrain(GridFrame::centred(20, 20, 90.0), 0.0F);
  terrain(10, 10) = 30.0F;
  const Grid<uint8_t> sea = flat_sea(terrain, {});
  EXPECT_EQ(sea(0, 0), 1);
  EXPECT_EQ(sea(10, 10), 0);
  EXPECT_EQ(sea(9, 11), 0);
  sink_flat_sea(terrain, sea, {});
  EXPECT_LT(terrain(0, 0), terrain(8, 8));
  EXPECT_LT(terrain(8, 8), 0.0F);
  EXPECT_EQ(terrain(10, 10), 30.0F);
}

TEST(FlatSea, ARealFloorIsLeftAlone) {
  const HeightField terrain(GridFrame::centred(20, 20, 90.0), -5.0F);
  EXPECT_TRUE(flat_sea(terrain, {}).empty());
}

}  // namespace
}  // namespace seamount::geom

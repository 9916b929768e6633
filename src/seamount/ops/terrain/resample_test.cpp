#include "seamount/ops/terrain/resample.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/scalar/noise.h"

namespace seamount::terrain {
namespace {

HeightField hills(const GridFrame& frame) {
  HeightField terrain = geom::fbm_grid(frame, Seed{5}, {.wavelength_m = 900, .octaves = 3}, {});
  for (float& z : terrain.cells()) z *= 250.0F;
  return terrain;
}

const GridFrame kDomain = GridFrame::centred(50, 40, 30.0);

TEST(ResampleTerrain, OnItsOwnFrameNothingChanges) {
  const HeightField terrain = hills(kDomain);
  EXPECT_EQ(resample(terrain, {}, kDomain, {}), terrain);
  EXPECT_EQ(resample(terrain, {.cell_m = 30.0}, GridFrame::centred(5, 5, 1.0), {}), terrain);
}

TEST(ResampleTerrain, LargerCellsAreAveragesSmallerOnesASurfaceThroughThem) {
  const HeightField terrain = hills(kDomain);
  const HeightField coarse = resample(terrain, {.cell_m = 60.0}, kDomain, {});
  ASSERT_EQ(coarse.frame(), GridFrame::centred(25, 20, 60.0));
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 25; ++x) {
      const double mean = 0.25 * (terrain(2 * x, 2 * y) + terrain(2 * x + 1, 2 * y) + terrain(2 * x, 2 * y + 1) +
                                  terrain(2 * x + 1, 2 * y + 1));
      ASSERT_NEAR(coarse(x, y), mean, 1e-3);
    }
  }
  const HeightField fine = resample(terrain, {.cell_m = 10.0}, kDomain, {});
  ASSERT_EQ(fine.width(), 150);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 50; ++x) ASSERT_NEAR(fine(3 * x + 1, 3 * y + 1), terrain(x, y), 1e-3);
  }
}

TEST(ResampleTerrain, ComesToTheMiddleOfTheDomainOrKeepsItsPlace) {
  const GridFrame far = {50, 40, 30.0, 4e5, 5e6, "EPSG:32633"};
  const HeightField here = hills(kDomain);
  HeightField there = here;
  there.set_frame(far);
  const HeightField centred = resample(there, {}, kDomain, {});
  EXPECT_EQ(centred.frame(), kDomain);
  for (size_t i = 0; i < here.size(); ++i) ASSERT_NEAR(centred.cells()[i], here.cells()[i], 1e-3);
  EXPECT_EQ(resample(there, {.cell_m = 30.0}, kDomain, {}), there);
  // Far from the domain its nearest cell, the south-western corner, is all that is left.
  const HeightField kept = resample(there, {.centre = false}, kDomain, {});
  EXPECT_EQ(kept(20, 20), there(0, 39));
}

TEST(ResampleTerrain, StretchesWidthAndHeightAlike) {
  const HeightField terrain = hills(kDomain);
  const HeightField twice = resample(terrain, {.cell_m = 60.0, .scale = 2.0}, kDomain, {});
  ASSERT_EQ(twice.frame(), GridFrame::centred(50, 40, 60.0));
  for (size_t i = 0; i < terrain.size(); ++i) ASSERT_NEAR(twice.cells()[i], 2.0 * terrain.cells()[i], 1e-3);
}

TEST(ResampleTerrain, RefusesMoreCellsThanThereIsRoomFor) {
  EXPECT_THROW(resample(hills(kDomain), {.cell_m = 0.01}, kDomain, {}), InvalidArgument);
  const HeightField one(GridFrame::centred(1, 1, 10.0), 7.0F);
  EXPECT_EQ(resample(one, {.cell_m = 100.0}, kDomain, {})(0, 0), 7.0F);
}

}  // namespace
}  // namespace seamount::terrain

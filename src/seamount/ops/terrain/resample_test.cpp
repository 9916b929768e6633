#include "seamount/ops/terrain/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

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
  // Far from the domain there is nothing of it, or, if it is let go on, its nearest cell: the south-western corner.
  EXPECT_THROW(resample(there, {.centre = false}, kDomain, {}), IncompatibleInputs);
  const HeightField kept = resample(there, {.centre = false, .beyond = Beyond::edge}, kDomain, {});
  EXPECT_EQ(kept(20, 20), there(0, 39));
}

TEST(ResampleTerrain, IsUnknownBeyondItsEdge) {
  const HeightField terrain = hills(kDomain);
  GridFrame wider = kDomain;
  wider.width += 20;
  wider.west_m -= 10 * wider.cell_m;
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said = line; };
  const HeightField out = resample(terrain, {}, wider, run);
  for (int y = 0; y < wider.height; ++y) {
    for (int x = 0; x < wider.width; ++x) {
      const bool inside = x >= 10 && x < 10 + kDomain.width;
      ASSERT_EQ(std::isnan(out(x, y)), !inside) << x << " " << y;
      if (!inside) continue;
      ASSERT_NEAR(out(x, y), terrain(x - 10, y), 1e-3);
    }
  }
  EXPECT_NE(said.find(std::to_string(20 * kDomain.height) + " of"), std::string::npos) << said;
}

/// A hole keeps its size at any cell size, to a cell around its rim.
TEST(ResampleTerrain, KeepsHoles) {
  HeightField terrain = hills(kDomain);
  int64_t holes = 0;
  for (int y = 0; y < kDomain.height; ++y) {
    for (int x = 0; x < kDomain.width; ++x) {
      if (std::hypot(x - 20, y - 15) > 8) continue;
      terrain(x, y) = std::nanf("");
      ++holes;
    }
  }
  const double area = static_cast<double>(holes) * kDomain.cell_m * kDomain.cell_m;
  for (const double cell_m : {10.0, 20.0, 30.0, 60.0, 90.0}) {
    const HeightField out = resample(terrain, {.cell_m = cell_m}, kDomain, {});
    const auto unknown = std::count_if(out.cells().begin(), out.cells().end(), [](float z) { return std::isnan(z); });
    const double rim = 2 * 3.2 * 8 * kDomain.cell_m * std::max(cell_m, kDomain.cell_m);
    EXPECT_NEAR(static_cast<double>(unknown) * cell_m * cell_m, area, 0.5 * rim) << cell_m;
    for (const float z : out.cells()) ASSERT_FALSE(std::abs(z) > 1e4);
  }
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

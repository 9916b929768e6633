#include "seamount/ops/terrain/compose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "seamount/geom/scalar/noise.h"

namespace seamount::terrain {
namespace {

HeightField hills(const GridFrame& frame, uint64_t seed = 5) {
  HeightField terrain = geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 2500, .octaves = 3}, {});
  for (float& z : terrain.cells()) z *= 250.0F;
  return terrain;
}

const GridFrame kFrame = GridFrame::centred(120, 100, 20.0);

TEST(Compose, ATerrainInItsPlaceIsItself) {
  const HeightField terrain = hills(kFrame);
  for (const double feather : {0.0, 300.0}) {
    const HeightField out = compose({&terrain}, {.feather_m = feather}, kFrame, {});
    for (size_t i = 0; i < out.size(); ++i) ASSERT_NEAR(out.cells()[i], terrain.cells()[i], 1e-3);
  }
}

TEST(Compose, EqualPlainsMakeOnePlainWhateverTheirPlaces) {
  const HeightField plain(GridFrame::centred(40, 30, 20.0), 42.0F);
  const ComposeParams params{
      .places = {{-500, 200}, {100, -100}, {600, 300}}, .turns_deg = {30, -70}, .outside_m = 42.0};
  const HeightField out = compose({&plain}, params, kFrame, {});
  for (const float z : out.cells()) ASSERT_NEAR(z, 42.0F, 1e-4);
}

TEST(Compose, LaterTerrainsLieOverEarlierOnes) {
  const HeightField low(kFrame, 10.0F), high(GridFrame::centred(30, 30, 20.0), 90.0F);
  const HeightField cut = compose({&low, &high}, {.feather_m = 0}, kFrame, {});
  EXPECT_EQ(cut(60, 50), 90.0F);
  EXPECT_EQ(cut(20, 50), 10.0F);
  EXPECT_EQ(std::count(cut.cells().begin(), cut.cells().end(), 90.0F), 900);
  const HeightField under = compose({&high, &low}, {.feather_m = 0}, kFrame, {});
  EXPECT_EQ(std::count(under.cells().begin(), under.cells().end(), 10.0F), 120 * 100);
}

TEST(Compose, SeamsAreSmoothAndFollowTheDistanceFromTheEdge) {
  const HeightField low(kFrame, 0.0F), high(GridFrame::centred(60, 60, 20.0), 100.0F);
  const HeightField out = compose({&low, &high}, {.feather_m = 200}, kFrame, {});
  // Column 35 lies 5.5 cells of 20 m inside the western edge: smoothstep(110 / 200).
  EXPECT_NEAR(out(35, 50), 100 * (3 * 0.55 * 0.55 - 2 * 0.55 * 0.55 * 0.55), 0.05);
  for (int x = 1; x < 120; ++x) ASSERT_LT(std::abs(out(x, 50) - out(x - 1, 50)), 17.0F);  // 1.5 steps of a tenth
}

TEST(Compose, AMosaicHasNoSeamsWhereItsTilesAgree) {
  const HeightField whole = hills(kFrame);
  const auto tile = [&](int x0, int y0, int width, int height) {
    GridFrame frame = kFrame;
    frame.width = width;
    frame.height = height;
    frame.west_m += 20.0 * x0;
    frame.north_m -= 20.0 * y0;
    HeightField out(frame);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) out(x, y) = whole(x0 + x, y0 + y);
    }
    return out;
  };
  const HeightField a = tile(0, 0, 70, 60), b = tile(50, 0, 70, 60), c = tile(0, 40, 70, 60), d = tile(50, 40, 70, 60);
  const HeightField out = compose({&a, &b, &c, &d}, {.feather_m = 300}, kFrame, {});
  for (int y = 2; y < 98; ++y) {
    // At the very edges one tile's continuation shows through for a thousandth.
    for (int x = 2; x < 118; ++x) ASSERT_NEAR(out(x, y), whole(x, y), 1.5) << x << " " << y;
  }
}

TEST(Compose, TurnsScalesAndRaises) {
  HeightField ramp(GridFrame::centred(60, 60, 20.0));
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) ramp(x, y) = static_cast<float>(0.1 * ramp.frame().x(x));  // rises to the east
  }
  const ComposeParams params{
      .places = {{100, -60}}, .turns_deg = {90}, .scales = {1.5}, .raises_m = {7}, .feather_m = 0, .outside_m = -5.0};
  const HeightField out = compose({&ramp}, params, kFrame, {});
  for (const auto& [x, y] : {std::pair{65, 53}, {60, 40}, {80, 60}}) {
    // Now it rises to the north, as steeply as before.
    ASSERT_NEAR(out(x, y), 0.1 * (kFrame.y(y) + 60) + 7, 1e-2);
  }
  EXPECT_EQ(out(0, 0), -5.0F);
}

TEST(Compose, FinerTerrainsAreAveraged) {
  HeightField stripes(GridFrame::centred(480, 400, 5.0));
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 480; ++x) stripes(x, y) = x % 2 == 0 ? 100.0F : 0.0F;
  }
  const HeightField out = compose({&stripes}, {}, kFrame, {});
  for (const float z : out.cells()) ASSERT_NEAR(z, 50.0F, 1e-3);
}

TEST(Compose, RefusesPlacesThatFitNeitherOneNorAll) {
  const HeightField a(kFrame, 1.0F);
  EXPECT_THROW(compose({&a, &a}, {.places = {{0, 0}, {1, 1}, {2, 2}}}, kFrame, {}), InvalidArgument);
  EXPECT_THROW(compose({}, {}, kFrame, {}), InvalidArgument);
  const HeightField one(GridFrame::centred(1, 1, 10.0), 3.0F);
  const HeightField column = compose({&one}, {}, GridFrame::centred(1, 5, 10.0), {});
  EXPECT_EQ(column(0, 2), 3.0F);
  EXPECT_TRUE(std::isnan(column(0, 4)));
}

/// Two sheets of one terrain, side by side with holes: all cells come back where they were.
TEST(Compose, JoinsNeighboursWithoutASeamAndKeepsHoles) {
  GridFrame whole = GridFrame::centred(50, 20, 30.0);
  whole.crs = "EPSG:32633";
  HeightField terrain(whole);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 50; ++x) terrain(x, y) = static_cast<float>(x * x % 17 + 3 * y);
  terrain(10, 5) = terrain(11, 5) = terrain(30, 0) = terrain(49, 19) = std::nanf("");
  const auto sheet = [&](int begin, int end) {
    GridFrame frame = whole;
    frame.width = end - begin;
    frame.west_m += begin * frame.cell_m;
    HeightField part(frame);
    for (int y = 0; y < 20; ++y)
      for (int x = begin; x < end; ++x) part(x - begin, y) = terrain(x, y);
    return part;
  };
  for (const int overlap : {0, 1, 5}) {
    const HeightField west = sheet(0, 23 + overlap), east = sheet(23, 50);
    const GridFrame frame = frame_around({&east, &west});
    EXPECT_EQ(frame, whole);
    const HeightField joined = compose({&west, &east}, {}, frame, {});
    for (size_t i = 0; i < terrain.size(); ++i) {
      ASSERT_EQ(std::isnan(joined.cells()[i]), std::isnan(terrain.cells()[i])) << overlap << " cell " << i;
      if (std::isnan(terrain.cells()[i])) continue;
      ASSERT_NEAR(joined.cells()[i], terrain.cells()[i], 1e-4) << overlap;
    }
  }
}

TEST(Compose, PiecesInALargeDomainLeaveTheRestUnknownAndSaySo) {
  const HeightField piece(GridFrame::centred(10, 10, 20.0), 90.0F);
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line; };
  const HeightField out = compose({&piece}, {.places = {{-600, 500}, {700, -300}}, .feather_m = 0}, kFrame, run);
  EXPECT_EQ(std::count_if(out.cells().begin(), out.cells().end(), [](float z) { return z == 90.0F; }), 200);
  EXPECT_EQ(said, "11800 of 12000 cells stay unknown: no terrain has a height there, and outside_m is not given");
  said.clear();
  compose({&piece}, {.places = {{-600, 500}}, .outside_m = 1.0}, kFrame, run);
  EXPECT_EQ(said, "");
}

TEST(Compose, SaysWhatLiesNowhereOnTheDomain) {
  const HeightField here(GridFrame::centred(10, 10, 10.0), 1.0F);
  HeightField far = here;
  far.set_frame({10, 10, 10.0, 5e5, 4e6, {}});
  try {
    compose({&here, &far}, {}, here.frame(), {});
    FAIL();
  } catch (const IncompatibleInputs& error) {
    EXPECT_NE(std::string(error.what()).find("terrain_2: lies nowhere on the domain: x 500000 to 500100 m"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace seamount::terrain

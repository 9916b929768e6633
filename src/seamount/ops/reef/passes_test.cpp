// No lagoon is cut off, and passes look like passes.
#include "seamount/ops/reef/passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/geom/polygon/distance.h"
#include "seamount/ops/reef/grow.h"
#include "seamount/ops/reef/regions.h"

namespace seamount::reef {
namespace {

/// Square kilometres of the largest water deeper than 4 m that does not reach the edge.
double largest_closed_km2(const HeightField& terrain) {
  Grid<uint8_t> wet(terrain.frame(), 0);
  for (size_t i = 0; i < wet.size(); ++i) wet.cells()[i] = terrain.cells()[i] < -kPassable_m ? 1 : 0;
  size_t most = 0;
  for (const RegionOfMask& region : regions_of(wet))
    if (!region.at_edge) most = std::max(most, region.cells.size());
  return static_cast<double>(most) * terrain.cell_m() * terrain.cell_m() * 1e-6;
}

Drawing ring(double radius_m) {
  Drawing drawing;
  ValuedLine line;
  for (int i = 0; i < 60; ++i) {
    const double a = i * std::numbers::pi / 30;
    line.points.push_back({radius_m * std::cos(a), radius_m * std::sin(a)});
  }
  line.closed = true;
  drawing.lines.push_back(line);
  return drawing;
}

TEST(ReefPasses, OpenEveryLagoonOfSomeSize) {
  const Drawing atoll = ring(2600);
  for (const uint64_t seed : {1, 2, 3}) {
    for (const double cell_m : {20.0, 150.0}) {
      const auto cells = static_cast<int>(9000 / cell_m);
      const HeightField base(GridFrame::centred(cells, cells, cell_m), -28.0F);
      GrowParams p;
      p.starts.line_cover = 1;
      p.particles = 600;
      const Grown open = grow({.terrain = base, .drawing = &atoll}, p, Seed{seed}, {});
      EXPECT_LT(largest_closed_km2(open.terrain), p.passes.least_km2) << seed << " " << cell_m;
      if (seed > 1 || cell_m > 100) continue;
      p.passes.least_km2 = 1e6;
      const Grown closed = grow({.terrain = base, .drawing = &atoll}, p, Seed{seed}, {});
      EXPECT_GT(largest_closed_km2(closed.terrain), 5.0) << "the law can fail";
    }
  }
}

TEST(ReefPasses, OpenPlatformsAndMazes) {
  for (const uint64_t seed : {4, 5, 6}) {
    for (const double stickiness : {1.0, 0.02}) {
      HeightField base(GridFrame::centred(300, 300, 25));
      for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 300; ++x)
          base(x, y) =
              static_cast<float>(-26 + 6 * std::sin(base.frame().x(x) / 900) * std::cos(base.frame().y(y) / 700));
      }
      GrowParams p;
      p.particles = stickiness < 1 ? 2000 : 0;
      p.walk.stickiness = stickiness;
      p.walk.launch = Launch::ring;
      const Grown grown = grow({base}, p, Seed{seed}, {});
      EXPECT_LT(largest_closed_km2(grown.terrain), p.passes.least_km2) << seed << " " << stickiness;
    }
  }
}

/// A ring of reef awash around a lagoon of 12 m on ground of 40 m, thinner in the east.
struct Atoll {
  HeightField ground{GridFrame::centred(300, 300, 40), -40.0F}, reef = ground;
  ScalarField exposure{ground.frame(), 0.0F};
  Atoll() {
    for (int y = 0; y < 300; ++y) {
      for (int x = 0; x < 300; ++x) {
        const double r = std::hypot(x - 149.5, y - 149.5) * 40, outer = x > 150 && std::abs(y - 150) < 12 ? 4200 : 4800;
        if (r < 4000) reef(x, y) = -12.0F;
        if (r >= 4000 && r < outer) reef(x, y) = -1.0F;
      }
    }
  }
};

TEST(ReefPasses, LieWhereTheReefIsThinOneForEachStretch) {
  const Atoll atoll;
  PassParams p;
  p.spacing_m = 1e6;
  const ScalarField one = find_passes(atoll.ground, atoll.reef, atoll.exposure, p, 40, {});
  ASSERT_FALSE(one.empty());
  Grid<uint8_t> dug(one.frame(), 0);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) {
      if (one(x, y) <= kPassable_m || atoll.reef(x, y) < -2) continue;
      dug(x, y) = 1;
      EXPECT_GT(x, 200) << "through the thin east";
      EXPECT_LT(std::abs(y - 150), 25);
    }
  }
  EXPECT_EQ(regions_of(dug).size(), 1U);
  p.spacing_m = 8000;  // on a shore of 25 km
  const ScalarField more = find_passes(atoll.ground, atoll.reef, atoll.exposure, p, 40, {});
  for (size_t i = 0; i < dug.size(); ++i)
    dug.cells()[i] = more.cells()[i] > kPassable_m && atoll.reef.cells()[i] > -2 ? 1 : 0;
  const size_t passes = regions_of(dug).size();
  EXPECT_GE(passes, 2U);
  EXPECT_LE(passes, 5U);
}

TEST(ReefPasses, AreAsWideAndDeepAsInNature) {
  const Atoll atoll;
  const ScalarField passes = find_passes(atoll.ground, atoll.reef, atoll.exposure, {}, 40, {});
  float deepest = 0, shallowest = 1e9F;
  double widest = 0;
  Grid<uint8_t> wall(passes.frame(), 0);
  for (size_t i = 0; i < wall.size(); ++i) wall.cells()[i] = passes.cells()[i] < kPassable_m ? 1 : 0;
  const ScalarField room = geom::distance_to(wall, {});
  for (size_t i = 0; i < wall.size(); ++i) {
    deepest = std::max(deepest, passes.cells()[i]);
    widest = std::max(widest, 2.0 * static_cast<double>(room.cells()[i]));
  }
  for (int y = 0; y < 300; ++y) {  // on the middle line of the reef
    float best = 0;
    for (int x = 250; x < 254; ++x) best = std::max(best, passes(x, y));
    if (best > 0 && std::abs(y - 150) < 4) shallowest = std::min(shallowest, best);
  }
  EXPECT_LE(deepest, 60.0F);
  EXPECT_GE(deepest, 10.0F);
  EXPECT_GE(widest, 100.0);
  EXPECT_LE(widest, 1200.0);
}

TEST(ReefPasses, LeaveAloneWhatTheGroundEncloses) {
  Atoll atoll;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x)
      if (atoll.reef(x, y) > -2) atoll.ground(x, y) = -1.0F;
  EXPECT_TRUE(find_passes(atoll.ground, atoll.reef, atoll.exposure, {}, 40, {}).empty());
  EXPECT_TRUE(find_passes(atoll.ground, atoll.ground, atoll.exposure, {.least_km2 = 1e6}, 40, {}).empty());
}

TEST(ReefPasses, NeverDigBelowTheGroundOnWhichTheReefStands) {
  const Drawing atoll = ring(2600);
  HeightField base(GridFrame::centred(400, 400, 22), -9.0F);
  GrowParams p;
  p.starts.line_cover = 1;
  p.particles = 300;
  const Grown grown = grow({.terrain = base, .drawing = &atoll}, p, Seed{3}, {});
  for (const float z : grown.terrain.cells()) ASSERT_GE(z, -9.001F);
}

}  // namespace
}  // namespace seamount::reef

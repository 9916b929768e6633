#include "seamount/ops/hydrology/lakes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/hydrology/fill.h"
#include "seamount/ops/hydrology/flow.h"
#include "seamount/ops/hydrology/rivers.h"

namespace seamount::hydrology {
namespace {

double attribute(const Attributes& attributes, std::string_view name) {
  for (const Attribute& one : attributes)
    if (one.name == name) return one.value;
  ADD_FAILURE() << "no " << name;
  return NAN;
}

HeightField hills(int width, int height, uint64_t seed, float base) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(width, height, 50), Seed{seed}, {.wavelength_m = 2500, .octaves = 5}, {});
  for (float& z : terrain.cells()) z = base + 400.0F * z;
  return terrain;
}

/// A cone down to -400 m in a plateau at 500 m, with a rim of a kilometre around and a sea beyond it in the west.
HeightField dead_sea() {
  HeightField terrain(GridFrame::centred(240, 200, 100));
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 240; ++x) {
      const double r = 100.0 * std::hypot(x - 140, y - 100);
      terrain(x, y) = static_cast<float>(std::min(500.0, -400.0 + 0.1 * r + 0.001 * y));
      if (r > 9500) terrain(x, y) = static_cast<float>(550.0 - 0.02 * (r - 9500));
      if (x < 20) terrain(x, y) = -50.0F;
    }
  }
  return terrain;
}

TEST(Lakes, ADeadSeaStandsWhereItsCatchmentKeepsIt) {
  const HeightField terrain = dead_sea();
  const LakesParams params{.runoff_mm_yr = 50, .rain_mm_yr = 100, .evaporation_mm_yr = 1600};
  const Lakes made = lakes(terrain, nullptr, params, {});
  ASSERT_EQ(made.lakes.areas.size(), 1U);
  const Attributes& lake = made.lakes.areas[0].attributes;
  const double area = attribute(lake, "area_m2"), catchment = M_PI * 9500.0 * 9500.0;
  EXPECT_EQ(attribute(lake, "closed"), 1.0);
  EXPECT_EQ(attribute(lake, "outflow_m3_s"), 0.0);
  EXPECT_NEAR(area, catchment * 50.0 / 1550.0, 0.03 * area);
  EXPECT_LT(attribute(lake, "level_m"), -200.0);
  EXPECT_NEAR(attribute(lake, "inflow_m3_s") * 365.25 * 86400, area * 1.5, 0.02 * area * 1.5);
  for (size_t i = 0; i < terrain.size(); ++i) {
    ASSERT_EQ(made.surface.data()[i], terrain.data()[i] + made.depth_m.data()[i]);
    ASSERT_EQ(made.sinks.data()[i], made.depth_m.data()[i] > 0.0F ? 1.0F : 0.0F);
  }
  // With more rain on it the lake grows, with the sea let in there is none.
  EXPECT_GT(attribute(lakes(terrain, nullptr, {.runoff_mm_yr = 50, .rain_mm_yr = 900, .evaporation_mm_yr = 1600}, {})
                          .lakes.areas[0]
                          .attributes,
                      "area_m2"),
            1.5 * area);
  EXPECT_TRUE(lakes(terrain, nullptr, {.min_sea_m2 = 1e6}, {}).lakes.areas.empty());
}

TEST(Lakes, WithoutEvaporationAreThoseOfFill) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField terrain = hills(140, 110, seed, 60.0F);
    const Lakes made = lakes(terrain, nullptr, {.evaporation_mm_yr = 0, .min_depth_m = 0, .min_lake_m2 = 0}, {});
    const Filled filled = fill(terrain, {.descend = false, .min_lake_m2 = 0}, {});
    EXPECT_EQ(made.surface, filled.terrain);
    double lakes_m3 = 0, filled_m3 = 0;
    for (const NamedArea& lake : made.lakes.areas) lakes_m3 += attribute(lake.attributes, "volume_m3");
    for (const NamedArea& lake : filled.lakes.areas) filled_m3 += attribute(lake.attributes, "volume_m3");
    EXPECT_NEAR(lakes_m3, filled_m3, 1e-6 * filled_m3);
    for (const float sink : made.sinks.cells()) EXPECT_EQ(sink, 0.0F);
    const Lakes dry = lakes(terrain, nullptr, {.evaporation_mm_yr = 1e6, .min_lake_m2 = 0}, {});
    EXPECT_EQ(dry.surface, terrain);
  }
}

TEST(Lakes, RiversEndInThem) {
  const HeightField terrain = dead_sea();
  const Lakes made = lakes(terrain, nullptr, {.runoff_mm_yr = 50, .rain_mm_yr = 100, .evaporation_mm_yr = 1600}, {});
  const Flow through = flow(terrain, {}, {}), ends = flow(terrain, &made.sinks, {}, {});
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 240; ++x) {
      if (made.depth_m(x, y) <= 0.0F) continue;
      EXPECT_LT(ends.direction_deg(x, y), 0.0F);
      EXPECT_EQ(ends.basins(x, y), ends.basins(140, 100));
      EXPECT_EQ(ends.terrain(x, y), terrain(x, y));
    }
  }
  const float basin = ends.basins(140, 100);
  double cells = 0;
  for (const float number : ends.basins.cells()) cells += number == basin ? 1 : 0;
  EXPECT_NEAR(cells * 1e4, M_PI * 9500 * 9500, 0.04 * M_PI * 9500 * 9500);
  EXPECT_GT(through.terrain(140, 100), 0.0F);
  const Drawing lines = rivers(terrain, &made.sinks, {.min_area_m2 = 1e6}, {});
  double drained = 0;
  for (const ValuedLine& line : lines.lines) {
    const Vec2 end = line.points.back();
    const int x = static_cast<int>(std::lround(terrain.frame().column(end.x)));
    const int y = static_cast<int>(std::lround(terrain.frame().row(end.y)));
    EXPECT_GE(attribute(line.attributes, "fall_m"), 0.0);
    if (made.depth_m(x, y) > 0.0F) drained += attribute(line.attributes, "area_m2");
  }
  EXPECT_GT(drained, 0.5 * cells * 1e4);
}

TEST(Lakes, RoughGroundHoldsNone) {
  HeightField terrain = dead_sea();
  for (int y = 1; y < 199; y += 7)
    for (int x = 25; x < 239; x += 9) terrain(x, y) -= 3.0F;
  const auto count_sinks = [&](double min_depth_m) {
    int64_t count = 0;
    const Lakes made = lakes(terrain, nullptr, {.runoff_mm_yr = 1, .min_depth_m = min_depth_m}, {});
    for (size_t i = 0; i < terrain.size(); ++i)
      count += made.sinks.data()[i] > 0.0F && made.depth_m.data()[i] <= 0.0F ? 1 : 0;
    return count;
  };
  EXPECT_GT(count_sinks(0), 100);
  EXPECT_LE(count_sinks(5), 1);
}

TEST(Lakes, RunoffOfEachCellAndUnknownGround) {
  HeightField terrain = dead_sea();
  ScalarField runoff(terrain.frame(), 50.0F);
  const LakesParams params{.runoff_mm_yr = 50};
  EXPECT_EQ(lakes(terrain, &runoff, params, {}).depth_m, lakes(terrain, nullptr, params, {}).depth_m);
  runoff(3, 3) = -1.0F;
  EXPECT_THROW(lakes(terrain, &runoff, params, {}), InvalidArgument);
  const ScalarField small(GridFrame::centred(3, 3, 100), 1.0F);
  EXPECT_THROW(lakes(terrain, &small, params, {}), IncompatibleInputs);
  terrain(140, 100) = std::numeric_limits<float>::quiet_NaN();
  const Lakes made = lakes(terrain, nullptr, params, {});
  EXPECT_TRUE(made.lakes.areas.empty());  // all leaves where nothing is known
  EXPECT_TRUE(std::isnan(made.surface(140, 100)));
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {2, 3}})
    EXPECT_TRUE(lakes(hills(width, height, 1, 20.0F), nullptr, {}, {}).lakes.areas.empty());
}

}  // namespace
}  // namespace seamount::hydrology

// Laws of the hydrology operators on random and synthetic terrains with known answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/hydrology/fill.h"
#include "seamount/ops/hydrology/flow.h"
#include "seamount/ops/hydrology/flow_spread.h"
#include "seamount/ops/hydrology/network.h"
#include "seamount/ops/hydrology/ridge_flow.h"
#include "seamount/ops/hydrology/rivers.h"

namespace seamount::hydrology {
namespace {

using ::testing::ElementsAre;

HeightField hills(int width, int height, uint64_t seed, float base = 100.0F) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(width, height, 30), Seed{seed}, {.wavelength_m = 900, .octaves = 6}, {});
  for (float& z : terrain.cells()) z = base + 300.0F * z;
  return terrain;
}

double attribute(const Attributes& attributes, std::string_view name) {
  for (const Attribute& one : attributes)
    if (one.name == name) return one.value;
  ADD_FAILURE() << "no " << name;
  return NAN;
}

HeightField plane(double angle_rad, int size) {
  HeightField terrain(GridFrame::centred(size, size, 10));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      terrain(x, y) = static_cast<float>(500 - std::cos(angle_rad) * x + std::sin(angle_rad) * y);
  return terrain;
}

TEST(Fill, ReportsTheLakeOfAKnownBowl) {
  // A square bowl of 3 x 3 cells, 4 m deep in the middle, 2 m at its sides, in a plain at 10 m.
  HeightField terrain(GridFrame::centred(9, 9, 10), 10.0F);
  for (int y = 3; y < 6; ++y)
    for (int x = 3; x < 6; ++x) terrain(x, y) = 8.0F;
  terrain(4, 4) = 6.0F;
  const Filled out = fill(terrain, {.min_lake_m2 = 0}, {});
  ASSERT_EQ(out.lakes.areas.size(), 1U);
  const NamedArea& lake = out.lakes.areas[0];
  EXPECT_EQ(lake.name, "lake 1");
  EXPECT_EQ(attribute(lake.attributes, "level_m"), 10.0);
  EXPECT_EQ(attribute(lake.attributes, "depth_m"), 4.0);
  EXPECT_EQ(attribute(lake.attributes, "area_m2"), 900.0);
  EXPECT_EQ(attribute(lake.attributes, "volume_m3"), 100.0 * (8 * 2 + 4));
  EXPECT_NEAR(out.change_m(4, 4), 4.0F, 1e-4F);
}

TEST(Fill, DescendsEverywhereOrIsFlat) {
  const HeightField terrain = hills(90, 70, 3);
  for (const bool descend : {true, false}) {
    const Filled out = fill(terrain, {.descend = descend, .sea = false}, {});
    int level = 0;
    for (int y = 1; y < 69; ++y) {
      for (int x = 1; x < 89; ++x) {
        bool lower = false;
        for (size_t k = 0; k < 8; ++k)
          lower = lower || out.terrain(x + geom::kFlowDx[k], y + geom::kFlowDy[k]) < out.terrain(x, y);
        level += lower ? 0 : 1;
      }
    }
    EXPECT_EQ(level == 0, descend);
  }
}

TEST(Fill, BreachingCutsLessThanFillingRaises) {
  const HeightField terrain = hills(120, 120, 9);
  const Filled breached = fill(terrain, {.depressions = Depressions::breach, .sea = false, .max_cut_m = 1e4}, {});
  const Filled filled = fill(terrain, {.sea = false}, {});
  double cut = 0, raised = 0, left = 0;
  for (size_t i = 0; i < terrain.size(); ++i) {
    cut += std::max(0.0F, -breached.change_m.data()[i]);
    left += std::max(0.0F, breached.change_m.data()[i]);
    raised += filled.change_m.data()[i];
  }
  EXPECT_GT(raised, 0);
  EXPECT_GT(cut, 0);
  EXPECT_LT(cut, raised);
  EXPECT_LT(left, 0.01 * raised);
  EXPECT_EQ(geom::count_pits(geom::flow_directions(breached.terrain, geom::kNoSea, {})), 0);
}

TEST(FlowOp, EveryMethodAddsUpToTheWholeMap) {
  const HeightField terrain = hills(101, 83, 5, 20.0F);
  for (const FlowMethod method : {FlowMethod::d8, FlowMethod::dinf, FlowMethod::mfd}) {
    const Flow out = flow(terrain, {.method = method}, {});
    double drained = 0;
    for (size_t i = 0; i < terrain.size(); ++i)
      if (out.direction_deg.data()[i] < 0) drained += static_cast<double>(out.cells.data()[i]);
    EXPECT_NEAR(drained, static_cast<double>(terrain.size()), 1e-5 * static_cast<double>(terrain.size()));
    for (size_t i = 0; i < terrain.size(); ++i) {
      ASSERT_GE(out.cells.data()[i], 1.0F);
      ASSERT_EQ(out.area_m2.data()[i], out.cells.data()[i] * 900.0F);
    }
  }
}

TEST(FlowOp, DinfFollowsThePlaneInAnyDirection) {
  for (int step = 0; step < 16; ++step) {
    const double angle = 2.0 * M_PI * step / 16.0;  // of the fall, counter-clockwise from east
    const HeightField terrain = plane(angle, 21);
    const geom::FlowDirections d8 = geom::flow_directions(terrain, geom::kNoSea, {});
    const ScalarField directions = dinf_directions(terrain, d8, geom::kNoSea, {});
    const double eighths = std::fmod(static_cast<double>(directions(10, 10)), 8.0);
    EXPECT_NEAR(std::remainder(eighths - step / 2.0, 8.0), 0.0, 1e-3) << step;
  }
}

TEST(FlowOp, MultipleFlowSharesInProportionToSlope) {
  // Down to the east by 3, to the south by 1; nowhere else.
  HeightField terrain(GridFrame::centred(3, 3, 1), 10.0F);
  terrain(1, 1) = 5.0F;
  terrain(2, 1) = 2.0F;
  terrain(1, 2) = 4.0F;
  const geom::FlowDirections d8 = geom::flow_directions(terrain, geom::kNoSea, {});
  const ScalarField linear = mfd_accumulation(terrain, d8, geom::kNoSea, 1.0, {});
  EXPECT_NEAR(linear(2, 1), 1.75F, 1e-6F);
  EXPECT_NEAR(linear(1, 2), 1.25F, 1e-6F);
  const ScalarField squared = mfd_accumulation(terrain, d8, geom::kNoSea, 2.0, {});
  EXPECT_NEAR(squared(2, 1), 1.9F, 1e-6F);
  EXPECT_NEAR(squared(1, 2), 1.1F, 1e-6F);
}

TEST(FlowOp, BasinsAreNumberedFromTheLargest) {
  const Flow out = flow(hills(80, 60, 2, 40.0F), {}, {});
  std::vector<int> sizes;
  for (const float basin : out.basins.cells()) {
    sizes.resize(std::max(sizes.size(), static_cast<size_t>(basin) + 1));
    ++sizes[static_cast<size_t>(basin)];
  }
  for (size_t i = 2; i < sizes.size(); ++i) EXPECT_LE(sizes[i], sizes[i - 1]);
}

/// A chain of cells in one row of a grid of the given width.
std::vector<Link> links_of(const std::vector<std::string>& codes, const std::vector<std::vector<float>>& sums) {
  const GridFrame frame = GridFrame::centred(static_cast<int>(codes[0].size()), static_cast<int>(codes.size()), 1);
  geom::FlowDirections directions(frame);
  ScalarField accumulation(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      directions(x, y) = static_cast<uint8_t>(codes[static_cast<size_t>(y)][static_cast<size_t>(x)] - '0');
      accumulation(x, y) = sums[static_cast<size_t>(y)][static_cast<size_t>(x)];
    }
  }
  return find_links(directions, accumulation, 1, nullptr, {});
}

TEST(Network, OrdersAreStrahlers) {
  // Two heads meet, a third of order 1 joins, and it all leaves in the east.
  //   0 0 7 . .        order 1, 1 -> 2; 2 + 1 stays 2
  //   0 0 0 0 8
  //   . 1 . 1 .
  const std::vector<Link> links =
      links_of({"77888", "00008", "81018"}, {{1, 0, 0, 0, 0}, {1, 3, 4, 6, 7}, {0, 0, 1, 1, 0}});
  std::multiset<int> orders;
  for (const Link& link : links) orders.insert(link.order);
  EXPECT_EQ(links.back().next, -1);
  EXPECT_EQ(links.back().order, 2);
  EXPECT_EQ(orders.count(1), 3U);
  for (size_t i = 0; i < links.size(); ++i) {
    if (links[i].next < 0) continue;
    EXPECT_GT(links[i].next, static_cast<int>(i));
    EXPECT_EQ(links[static_cast<size_t>(links[i].next)].cells.front(), links[i].cells.back());
  }
}

TEST(Flow, CatchmentsCoverTheirCells) {
  const HeightField terrain = hills(90, 70, 3, 500.0F);
  const Flow made = flow(terrain, {.min_catchment_m2 = 0}, {});
  double covered = 0, largest = INFINITY;
  for (const NamedArea& area : made.catchments.areas) {
    const double area_m2 = attribute(area.attributes, "area_m2");
    double traced = 0;
    for (const Polygon& polygon : area.parts) traced += geom::area(polygon);
    EXPECT_NEAR(traced, area_m2, 0.05 * area_m2 + 1800);  // stair steps are smoothed
    EXPECT_LE(area_m2, largest);
    largest = area_m2;
    covered += area_m2;
    const GridFrame& frame = terrain.frame();
    const int x = static_cast<int>(std::lround(frame.column(attribute(area.attributes, "mouth_x"))));
    const int y = static_cast<int>(std::lround(frame.row(attribute(area.attributes, "mouth_y"))));
    EXPECT_EQ(made.area_m2(x, y), static_cast<float>(area_m2));
  }
  EXPECT_NEAR(covered, 90 * 70 * 900.0, 1.0);
  EXPECT_LT(flow(terrain, {}, {}).catchments.areas.size(), made.catchments.areas.size());
}

TEST(Rivers, NeverClimbAndGrowDownstream) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField terrain = hills(160, 130, seed, 60.0F);
    const HeightField filled = fill(terrain, {.descend = false}, {}).terrain;
    const Drawing drawing = rivers(terrain, {.min_area_m2 = 50 * 900.0}, {});
    ASSERT_GT(drawing.lines.size(), 20U);
    for (const ValuedLine& line : drawing.lines) {
      ASSERT_GE(line.points.size(), 2U);
      float previous = INFINITY;
      for (const Vec2& p : line.points) {
        const float z = filled(static_cast<int>(std::lround(terrain.frame().column(p.x))),
                               static_cast<int>(std::lround(terrain.frame().row(p.y))));
        EXPECT_LE(z, previous);
        previous = z;
      }
      EXPECT_EQ(line.value, attribute(line.attributes, "order"));
      const double discharge = attribute(line.attributes, "discharge_m3_s");
      EXPECT_NEAR(discharge, attribute(line.attributes, "area_m2") * 0.5 / (365.25 * 86400), 1e-9);
      EXPECT_NEAR(attribute(line.attributes, "width_m"), 6 * std::sqrt(discharge), 1e-9);
      EXPECT_GE(attribute(line.attributes, "fall_m"), 0.0);
      EXPECT_GE(attribute(line.attributes, "area_m2"), 50 * 900.0);
    }
  }
}

TEST(Rivers, RunThroughHollowsBelowSeaLevel) {
  // A valley to a sea in the east, with a hole of one cell in its floor.
  HeightField terrain(GridFrame::centred(80, 31, 10));
  for (int y = 0; y < 31; ++y) {
    for (int x = 0; x < 80; ++x)
      terrain(x, y) = 0.1F * static_cast<float>(70 - x) + std::abs(static_cast<float>(y - 15));
  }
  terrain(40, 15) = -0.45F;
  const RiversParams params{.min_area_m2 = 200 * 100.0};
  const Drawing through = rivers(terrain, params, {});
  const auto largest = [](const Drawing& drawing) {
    double most = 0;
    for (const ValuedLine& line : drawing.lines) most = std::max(most, attribute(line.attributes, "area_m2"));
    return most;
  };
  EXPECT_GT(largest(through), 50 * 20 * 100.0);
  EXPECT_LT(largest(rivers(terrain, {.min_area_m2 = 200 * 100.0, .min_sea_m2 = 0}, {})), 0.7 * largest(through));
  const Filled filled = fill(terrain, {.min_lake_m2 = 0}, {});
  ASSERT_EQ(filled.lakes.areas.size(), 1U);
  EXPECT_NEAR(attribute(filled.lakes.areas[0].attributes, "depth_m"), 3.35,
              1e-4);  // to the level of the floor beside it
  EXPECT_EQ(filled.terrain(79, 15), terrain(79, 15));
}

TEST(Rivers, CountTheLandForWhereTheyBegin) {
  HeightField island = hills(60, 60, 2, 300.0F), sea(GridFrame::centred(240, 240, 30), -50.0F);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) sea(90 + x, 90 + y) = island(x, y);
  }
  EXPECT_GT(rivers(sea, {}, {}).lines.size(), rivers(sea, {.min_area_m2 = 240 * 240 * 900 / 500.0}, {}).lines.size());
}

TEST(Ridges, OfARoofIsItsCrest) {
  HeightField terrain(GridFrame::centred(41, 61, 10));
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 41; ++x)
      terrain(x, y) = 200.0F - 5.0F * std::abs(static_cast<float>(x - 20)) - 0.01F * static_cast<float>(y);
  const Drawing drawing = ridges(terrain, {.min_area_m2 = 30 * 41 * 100.0}, {});
  ASSERT_EQ(drawing.lines.size(), 1U);
  for (const Vec2& p : drawing.lines[0].points) EXPECT_NEAR(p.x, 0.0, 1e-9);
  EXPECT_GT(drawing.lines[0].points.back().y, drawing.lines[0].points.front().y);
  EXPECT_GT(attribute(drawing.lines[0].attributes, "rise_m"), 0.0);
}

TEST(Ridges, StandInABasinBelowTheSeaAsAboveIt) {
  // The same roof, in a basin with its crest at -100 m and a rim at 300 m all around.
  HeightField terrain(GridFrame::centred(81, 101, 10), 300.0F);
  for (int y = 20; y < 81; ++y)
    for (int x = 20; x < 61; ++x)
      terrain(x, y) = -100.0F - 5.0F * std::abs(static_cast<float>(x - 40)) - 0.01F * static_cast<float>(y);
  const Drawing drawing = ridges(terrain, {.min_area_m2 = 15 * 41 * 100.0}, {});
  double crest_m = 0.0;
  for (const ValuedLine& line : drawing.lines)
    for (size_t i = 1; i < line.points.size(); ++i)
      if (std::abs(line.points[i - 1].x) < 5 && std::abs(line.points[i].x) < 5)
        crest_m += line.points[i].y - line.points[i - 1].y;
  EXPECT_GT(crest_m, 300.0);
}

TEST(Ridges, StayOnTheirIslandAndEndOnItsSummit) {
  HeightField terrain = hills(140, 110, 4, 10.0F);
  const RidgeFlow flow = ridge_flow(terrain, 0.0F, {});
  const auto steps = geom::flow_steps(terrain.width());
  double summit_cells = 0;
  int64_t land = 0;
  for (int64_t i = 0; i < terrain.frame().cells(); ++i) {
    if (flow.land.data()[i] == 0) continue;
    ++land;
    if (flow.directions.data()[i] == geom::kPit)
      summit_cells += static_cast<double>(flow.cells.data()[i]);
    else
      ASSERT_NE(flow.land.data()[i + steps[flow.directions.data()[i]]], 0);
  }
  EXPECT_EQ(summit_cells, static_cast<double>(land));
  EXPECT_LT(geom::count_pits(flow.directions), 60);
}

TEST(Hydrology, TakesOddShapes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 3}}) {
    const HeightField terrain = hills(width, height, 1, 20.0F);
    EXPECT_EQ(fill(terrain, {.depressions = Depressions::breach}, {}).terrain, terrain);
    for (const FlowMethod method : {FlowMethod::d8, FlowMethod::dinf, FlowMethod::mfd})
      EXPECT_EQ(flow(terrain, {.method = method}, {}).cells.size(), terrain.size());
    EXPECT_TRUE(rivers(terrain, {}, {}).lines.empty());
    ridges(terrain, {}, {});
  }
}

/// A round catchment in a void: water leaves at its rim, all of it, and nothing gathers beyond.
TEST(Voids, AreOutlets) {
  for (const double tilt : {0.5, 2.0, -1.0}) {
    HeightField terrain(GridFrame::centred(120, 120, 30.0));
    int64_t known = 0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) {
        const bool inside = std::hypot(x - 60, y - 60) < 50;
        known += inside ? 1 : 0;
        terrain(x, y) = inside ? static_cast<float>(500 + tilt * x + 0.8 * std::abs(y - 60))
                               : std::numeric_limits<float>::quiet_NaN();
      }
    }
    for (const FlowMethod method : {FlowMethod::d8, FlowMethod::dinf, FlowMethod::mfd}) {
      const Flow out = flow(terrain, {.method = method}, {});
      float most = 0;
      for (size_t i = 0; i < terrain.size(); ++i) {
        ASSERT_EQ(std::isnan(out.cells.cells()[i]), std::isnan(terrain.cells()[i]));
        ASSERT_EQ(std::isnan(out.terrain.cells()[i]), std::isnan(terrain.cells()[i]));
        if (!std::isnan(terrain.cells()[i])) most = std::max(most, out.cells.cells()[i]);
      }
      EXPECT_LE(most, static_cast<float>(known));
      EXPECT_GT(most, 50.0F);
    }
    const Drawing lines = rivers(terrain, {}, {});
    ASSERT_FALSE(lines.lines.empty());
    for (const ValuedLine& line : lines.lines)
      for (const Attribute& attribute : line.attributes) ASSERT_TRUE(std::isfinite(attribute.value)) << attribute.name;
    const Filled filled = fill(terrain, {}, {});
    for (size_t i = 0; i < terrain.size(); ++i)
      ASSERT_EQ(std::isnan(filled.change_m.cells()[i]), std::isnan(terrain.cells()[i]));
  }
}

}  // namespace
}  // namespace seamount::hydrology

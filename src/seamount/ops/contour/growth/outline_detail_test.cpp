#include "seamount/ops/contour/growth/outline_detail.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/geom/polygon/polygon.h"

namespace seamount::contour {
namespace {

const GridFrame kDomain = GridFrame::centred(200, 200, 50);
constexpr uint64_t kScenes = 100;

Ring polygon(Vec2 centre, double radius, int sides) {
  Ring ring;
  ring.reserve(static_cast<size_t>(sides));
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    ring.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

RegionTree island() {
  return nest_regions({{"coast", polygon({0, 0}, 4000, 8), -1, 0.0, false, {}},
                       {"west", polygon({-1600, 0}, 1100, 5), 0, 200.0, false, {}},
                       {"east", polygon({1600, 300}, 900, 3), 0, 300.0, false, {}},
                       {"crater", polygon({-1600, 0}, 300, 4), 1, 150.0, true, {}}},
                      kDomain, "outlines");
}

RegionTree detailed(RegionTree tree, double irregularity, uint64_t seed, std::vector<RiverLine> rivers = {}) {
  add_outline_detail(tree, rivers, irregularity, kDomain, Seed{seed}, RunContext());
  return tree;
}

/// The farthest that a ring's points between two places of it lie from the line through them.
double sagitta(const Ring& ring, size_t from, size_t to) {
  const Vec2 along = ring[to] - ring[from];
  double most = 0.0;
  for (size_t i = from; i < to; ++i)
    most = std::max(most, std::abs(cross(along, ring[i] - ring[from])) / std::sqrt(dot(along, along)));
  return most;
}

TEST(OutlineDetail, KeepsNamesHeightsAndNesting) {
  const RegionTree drawn = island();
  for (uint64_t seed = 0; seed < kScenes; ++seed) {
    const RegionTree tree = detailed(drawn, 1.0, seed);
    ASSERT_EQ(tree.regions.size(), drawn.regions.size());
    for (size_t i = 0; i < tree.regions.size(); ++i) {
      EXPECT_EQ(tree.regions[i].name, drawn.regions[i].name);
      EXPECT_EQ(tree.regions[i].parent, drawn.regions[i].parent);
      EXPECT_EQ(tree.regions[i].height_m, drawn.regions[i].height_m);
      EXPECT_EQ(tree.regions[i].basin, drawn.regions[i].basin);
    }
  }
}

TEST(OutlineDetail, KeepsWhatWasDrawnAndLeavesNoStraightSide) {
  const Ring drawn = island().regions[0].outline;
  for (uint64_t seed = 0; seed < kScenes; ++seed) {
    const Ring coast = detailed(island(), 0.5, seed).regions[0].outline;
    EXPECT_NEAR(geom::signed_area(coast), std::numbers::pi * 4000 * 4000, 0.15 * std::numbers::pi * 4000 * 4000);
    for (const Vec2 p : coast) EXPECT_NEAR(std::sqrt(dot(p, p)), 4000, 1200);
    const size_t piece = coast.size() / 24;  // a third of a side
    for (size_t i = 0; i + piece < coast.size(); i += piece) EXPECT_GT(sagitta(coast, i, i + piece), 4.0);
  }
}

TEST(OutlineDetail, OutlinesBeyondTheDomainStayAsTheyAre) {
  const Ring square = {{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}};
  const Ring base =
      detailed(nest_regions({{"base", square, -1, {}, false, {}}}, kDomain, "outlines"), 1.0, 1).regions[0].outline;
  EXPECT_GT(base.size(), 100U);
  for (const Vec2 p : base) EXPECT_EQ(std::max(std::abs(p.x), std::abs(p.y)), 9000.0);
}

TEST(OutlineDetail, RiversMoveWithTheOutlinesAroundThem) {
  RegionTree tree = island();
  std::vector<RiverLine> rivers = {{{{0, 0}, {1000, 2000}}, {}, 0, 0}};
  // A drawn point on the coast: the spline goes through it, and both are displaced alike.
  rivers[0].points.push_back(tree.regions[0].outline[1]);
  add_outline_detail(tree, rivers, 0.7, kDomain, Seed{4}, RunContext());
  const Vec2 mouth = rivers[0].points.back();
  EXPECT_THAT(tree.regions[0].outline, ::testing::Contains(mouth));
}

TEST(OutlineDetail, IsTheSameForASeedAndDiffersBySeed) {
  EXPECT_EQ(detailed(island(), 0.7, 3), detailed(island(), 0.7, 3));
  EXPECT_NE(detailed(island(), 0.7, 3).regions[0].outline, detailed(island(), 0.7, 4).regions[0].outline);
}

TEST(OutlineDetail, SaysWhereRoundedOutlinesCross) {
  // The spline through a square's corners bulges over its sides, the one through many points of them does not.
  Ring outer;
  outer.reserve(80);
  for (int i = -10; i < 10; ++i) outer.push_back({300.0 * i, -3000});
  for (int i = -10; i < 10; ++i) outer.push_back({3000, 300.0 * i});
  for (int i = -10; i < 10; ++i) outer.push_back({-300.0 * i, 3000});
  for (int i = -10; i < 10; ++i) outer.push_back({-3000, -300.0 * i});
  const Ring inner = {{-2900, -2900}, {2900, -2900}, {2900, 2900}, {-2900, 2900}};
  RegionTree tree =
      nest_regions({{"outer", outer, -1, {}, false, {}}, {"inner", inner, 0, {}, false, {}}}, kDomain, "outlines");
  std::vector<RiverLine> rivers;
  EXPECT_THROW(add_outline_detail(tree, rivers, 0.1, kDomain, Seed{1}, RunContext()), InvalidArgument);
}

}  // namespace
}  // namespace seamount::contour

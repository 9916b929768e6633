#include "seamount/ops/contour/growth/rivers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/geom/tin/node_graph.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/heights/heights.h"

namespace seamount::contour {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const GridFrame kDomain = GridFrame::centred(120, 100, 10);

size_t at(int32_t i) { return static_cast<size_t>(i); }

Ring square(double half, Vec2 centre = {}) {
  return {centre + Vec2{-half, -half}, centre + Vec2{half, -half}, centre + Vec2{half, half},
          centre + Vec2{-half, half}};
}

RegionTree isle() { return regions_from_outlines({{"isle", square(400), 0.0, false}}, kDomain, "outlines"); }

std::string message(const std::vector<RiverLine>& lines) {
  try {
    prepare_rivers(lines, isle(), kDomain, 10.0, "rivers");
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(GrowthRivers, BedsFallFromSourceToMouth) {
  const RiverLine main{{{0, 300}, {30, 100}, {-20, -150}, {0, -420}}, {200, 120, 120, 0}, 0, 40};
  const RiverLine side{{{300, 50}, {150, 20}, {35, 90}}, {}, 0, 0};
  const std::vector<River> rivers = prepare_rivers({side, main}, isle(), kDomain, 10.0, "rivers");
  ASSERT_EQ(rivers.size(), 2U);
  for (const River& river : rivers) {
    for (size_t i = 1; i < river.points.size(); ++i) EXPECT_LT(river.bed_m[i], river.bed_m[i - 1]);
  }
  EXPECT_NEAR(rivers[0].bed_m.front(), 200, 0.1);  // the river that is joined comes first
  EXPECT_NEAR(rivers[0].bed_m.back(), 0, 1e-9);
  EXPECT_DOUBLE_EQ(rivers[0].half_m.front(), 0);
  EXPECT_DOUBLE_EQ(rivers[0].half_m.back(), 20);
  EXPECT_NEAR(rivers[1].bed_m.back(), 120, 2);  // where it joins
  const double fall = rivers[1].bed_m.front() - rivers[1].bed_m.back();
  EXPECT_NEAR(fall, 0.03 * 290, 1.5);
}

TEST(GrowthRivers, MessagesNameTheRiverAndThePlace) {
  EXPECT_THAT(message({{{{0, 0}}, {}, 0, 0}}), HasSubstr("rivers: river 0 has 1 points"));
  EXPECT_THAT(message({{{{0, 0}, {0, -500}}, {10, 20}, 0, 0}}),
              AllOf(HasSubstr("rises from 10 to 20 m on its way to (0, -500)"), HasSubstr("source to mouth")));
  EXPECT_THAT(message({{{{0, 0}, {0, -100}, {0, -200}, {0, -500}}, {30, 20, 10}, 0, 0}}),
              HasSubstr("has 3 beds for 4 points"));
  EXPECT_THAT(message({{{{500, 0}, {560, 0}}, {}, 0, 0}}), HasSubstr("lies wholly outside the regions"));
  EXPECT_THAT(message({{{{0, 200}, {0, -500}}, {100, 0}, 0, 0}, {{{300, 0}, {0, 0}}, {50, 5}, 0, 0}}),
              AllOf(HasSubstr("river 1 ends at 5 m, below river 0"), HasSubstr("joins at (0, 0)")));
  EXPECT_THAT(message({{{{0, 0}, {100, 0}, {100, 100}}, {}, 0, 0}, {{{100, 100}, {0, 100}, {0, 0}}, {}, 0, 0}}),
              HasSubstr("flows back into it"));
  EXPECT_THAT(message({{{{0, 300}, {0, 100}}, {}, 0, 0}}),
              AllOf(HasSubstr("ends on land at (0, 100)"), HasSubstr("m from the nearest shore at (")));
  EXPECT_EQ(message({{{{0, 300}, {0, -350}}, {}, 0, 0}}), "");
  EXPECT_THAT(message({{{{0, 0}, {std::nan(""), 0}}, {}, 0, 0}}), HasSubstr("no finite place"));
  EXPECT_THAT(message({{{{0, 0}, {0, 0}}, {}, 0, 0}}), HasSubstr("has no length"));
}

TEST(GrowthRivers, ReachesWithFallsAddUpFromTheMouth) {
  Drawing drawing;
  drawing.lines.push_back({{{0, 200}, {0, 100}}, 1, false, {{"fall_m", 30}, {"width_m", 8}}});
  drawing.lines.push_back({{{0, 100}, {0, -450}}, 2, false, {{"fall_m", 12}}});
  drawing.lines.push_back({{{50, 0}, {20, 0}}, 1, false, {{"source_m", 40}, {"mouth_m", 22}}});
  const std::vector<RiverLine> lines = river_lines(drawing);
  EXPECT_EQ(lines[0].bed_m, (std::vector<double>{42, 12}));
  EXPECT_EQ(lines[0].mouth_width_m, 8);
  EXPECT_EQ(lines[1].bed_m, (std::vector<double>{12, 0}));
  EXPECT_EQ(lines[2].bed_m, (std::vector<double>{40, 22}));
}

class RiverScene : public ::testing::TestWithParam<uint64_t> {
 protected:
  Tin made() const {
    GrowParams params;
    params.particles = 5000;
    params.rivers = {{{{20, 330}, {-60, 150}, {50, -50}, {-30, -250}, {0, -430}}, {260, 0}, 0, 90},
                     {{{330, 60}, {200, 80}, {30, 0}}, {}, 0, 0}};
    const Tin tin = grow(isle(), kDomain, nullptr, {}, params, Seed{GetParam()}, {});
    HeightsParams heights_params;
    heights_params.max_m = 700;
    return heights(tin, nullptr, heights_params, {});
  }
};

TEST_P(RiverScene, BedsAreKeptAndNoLandBesideThemIsLower) {
  const Tin tin = made();
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size());
  int rivers = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    if (tin.bed_m[i] == Tin::kNoBed) continue;
    ++rivers;
    EXPECT_NEAR(tin.height_m[i], tin.bed_m[i], 0.02F);
    for (const int32_t n : graph.around(i)) {
      if (tin.region[at(n)] < 0 || tin.bed_m[at(n)] != Tin::kNoBed) continue;
      EXPECT_GE(tin.height_m[at(n)], tin.height_m[i]);
    }
  }
  EXPECT_GT(rivers, 150);
}

TEST_P(RiverScene, NothingIsEndorheic) {
  const Tin tin = made();
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size());
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    if (tin.region[i] < 0) continue;
    const auto around = graph.around(i);
    EXPECT_TRUE(std::any_of(around.begin(), around.end(),
                            [&](int32_t n) { return tin.height_m[at(n)] < tin.height_m[i] || tin.region[at(n)] < 0; }))
        << tin.nodes[i].x << " " << tin.nodes[i].y;
  }
}

TEST_P(RiverScene, ContoursBendUpstream) {
  // On a line across the river, 60 to 90 m from it the ground is higher than at the river, on both sides.
  const Tin tin = made();
  double west = 0, east = 0;
  int wests = 0, easts = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    const Vec2 p = tin.nodes[i];
    if (p.y < 60 || p.y > 160) continue;
    const double x = p.x - (-60 + (150 - p.y) * 0.45);
    if (std::abs(x) < 60 || std::abs(x) > 90) continue;
    (x < 0 ? west : east) += static_cast<double>(tin.height_m[i]);
    ++(x < 0 ? wests : easts);
  }
  const double bed = 260 * 0.4 * 0.4;  // graded, about 0.62 of the way from the mouth
  EXPECT_GT(west / wests, bed + 40);
  EXPECT_GT(east / easts, bed + 40);
}

TEST_P(RiverScene, RiversAreChainsOfSides) {
  const Tin tin = made();
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size());
  int ends = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    if (tin.bed_m[i] == Tin::kNoBed) continue;
    const auto around = graph.around(i);
    ends += std::none_of(around.begin(), around.end(),
                         [&](int32_t n) { return tin.bed_m[at(n)] < tin.bed_m[i] && tin.bed_m[at(n)] != Tin::kNoBed; });
  }
  EXPECT_LE(ends, 2);  // the mouth, perhaps beside the coast in two
}

INSTANTIATE_TEST_SUITE_P(Seeds, RiverScene, ::testing::Values(1, 2, 3, 4, 5));

}  // namespace
}  // namespace seamount::contour

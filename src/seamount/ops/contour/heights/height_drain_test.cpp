// Water's way down networks whose heights do not follow their ranks (node_heights.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/tin/test_tin.h"
#include "seamount/geom/tin/tin_raster.h"
#include "seamount/ops/contour/heights/node_heights.h"

namespace seamount::contour {
namespace {

/// A plateau that ranks say drains to the west, lower along its eastern edge: water leaves there too.
TEST(HeightDrain, NothingIsCutForWaterThatLeavesAtTheEdgeOfTheNetwork) {
  Tin tin = geom::lattice_tin(20, 12, 10.0, Seed{1}, [](Vec2) { return 0.0; });
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size());
  tin.regions = {{"plateau", -1, {}, 0.0, false, {}}};
  tin.region.assign(tin.nodes.size(), 0);
  std::vector<double> height;
  double east = -1e9, west = 1e9;
  for (const Vec2 p : tin.nodes) east = std::max(east, p.x), west = std::min(west, p.x);
  for (const Vec2 p : tin.nodes) {
    tin.rank.push_back(static_cast<float>(0.1 + 0.8 * (p.x - west) / (east - west)));
    height.push_back(p.x > east - 5.0 ? 30.0 : 100.0 + 0.1 * p.x);
  }
  const std::vector<double> none(tin.nodes.size(), -1e9), all(tin.nodes.size(), 1e9);
  const std::vector<float> drained = drain(tin, graph, {{0, 0, 0.0, 200.0, 0.0, true, false}}, {none, all}, height, {});
  for (size_t i = 0; i < height.size(); ++i) EXPECT_NEAR(drained[i], height[i], 0.01) << i;
}

TEST(HeightDrain, HollowsBetweenBedsAreLifted) {
  Tin tin = geom::lattice_tin(21, 21, 10.0, Seed{2}, [](Vec2) { return 0.0; });
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size());
  tin.regions = {{"plateau", -1, {}, 0.0, false, {}}};
  tin.region.assign(tin.nodes.size(), 0);
  tin.bed_m.assign(tin.nodes.size(), Tin::kNoBed);
  std::vector<double> height;
  for (const Vec2 p : tin.nodes) height.push_back(200.0 - 1.5 * std::abs(std::hypot(p.x, p.y) - 60.0));  // a ring
  const std::vector<double> none(tin.nodes.size(), -1e9), all(tin.nodes.size(), 1e9);
  std::vector<double> lifted = height;
  fill_behind_rivers(tin, graph, {none, all}, lifted, {});
  tin.height_m.assign(lifted.begin(), lifted.end());
  EXPECT_EQ(geom::find_low_nodes(tin).size(), 0U);
  for (size_t i = 0; i < height.size(); ++i) EXPECT_GE(lifted[i], height[i]);
  tin.bed_m.clear();
  std::vector<double> same = height;
  fill_behind_rivers(tin, graph, {none, all}, same, {});
  EXPECT_EQ(same, height) << "without rivers ranks and heights agree";
}

}  // namespace
}  // namespace seamount::contour

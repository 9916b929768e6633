#include "seamount/geom/contour/marching_open_triangles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamount::geom {
namespace {

/// A square lattice cut into triangles; heights from a function.
template <class Height>
HeightMesh lattice(int side, Height&& height) {
  HeightMesh mesh;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      mesh.nodes.push_back({x + 0.0, y + 0.0});
      mesh.height_m.push_back(height(mesh.nodes.back()));
    }
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const int32_t i = y * side + x;
      mesh.triangles.push_back({i, i + 1, i + side + 1});
      mesh.triangles.push_back({i, i + side + 1, i + side});
    }
  }
  return mesh;
}

TEST(MarchOpenTriangles, LinesEndAtTheBorderWithHigherGroundOnTheLeft) {
  const HeightMesh mesh = lattice(9, [](Vec2 p) { return p.x + 0.25; });
  const std::vector<LevelChain> chains = march_open_triangles(mesh, {2.5, 4.0});
  ASSERT_EQ(chains.size(), 2U);
  for (const LevelChain& chain : chains) {
    EXPECT_FALSE(chain.closed);
    for (const Vec2 p : chain.points) EXPECT_NEAR(p.x, chain.height_m - 0.25, 1e-12);
    EXPECT_EQ(chain.points.front().y, 8.0) << "southwards, so that the east, which is higher, lies on the left";
    EXPECT_EQ(chain.points.back().y, 0.0);
    const Vec2 first = mesh.nodes[static_cast<size_t>(chain.first_node)];
    const Vec2 last = mesh.nodes[static_cast<size_t>(chain.last_node)];
    EXPECT_EQ(first, (Vec2{std::ceil(chain.height_m - 0.25), 8}));
    EXPECT_EQ(last, (Vec2{std::ceil(chain.height_m - 0.25), 0}));
  }
}

TEST(MarchOpenTriangles, AHillIsClosedAndANodeAtTheLevelIsPassedOnce) {
  const HeightMesh mesh = lattice(9, [](Vec2 p) { return 4.0 - std::abs(p.x - 4) - std::abs(p.y - 4); });
  const std::vector<LevelChain> chains = march_open_triangles(mesh, {1.0, 2.0, 3.5});
  ASSERT_EQ(chains.size(), 3U);
  for (const LevelChain& chain : chains) {
    EXPECT_TRUE(chain.closed);
    double twice_area = 0.0;
    for (size_t i = 0; i < chain.points.size(); ++i) {
      const Vec2 p = chain.points[i], q = chain.points[(i + 1) % chain.points.size()];
      twice_area += cross(p, q);
      EXPECT_FALSE(p == q);
    }
    const double radius = 4.0 - chain.height_m;
    EXPECT_NEAR(twice_area, 4.0 * radius * radius, 1e-12) << "counter-clockwise around the summit";
  }
}

TEST(MarchOpenTriangles, NothingWhereNoLevelIsReached) {
  EXPECT_TRUE(march_open_triangles(lattice(3, [](Vec2) { return 1.0; }), {0.5, 2.0}).empty());
  EXPECT_TRUE(march_open_triangles({}, {0.5}).empty());
}

}  // namespace
}  // namespace seamount::geom

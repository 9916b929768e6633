#include "seamount/geom/mesh/mesh_domain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "seamount/geom/mesh/test_surface.h"
#include "seamount/geom/tin/delaunay.h"

namespace seamount::geom {
namespace {

/// '#' a cell with a height, '.' one without.
HeightField drawn(const std::vector<std::string>& rows) {
  HeightField heights(GridFrame::centred(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1), 1.0F);
  for (int y = 0; y < heights.height(); ++y)
    for (int x = 0; x < heights.width(); ++x)
      if (rows[static_cast<size_t>(y)][static_cast<size_t>(x)] == '.') heights(x, y) = std::nanf("");
  return heights;
}

TEST(MeshDomain, IsAllOfATerrainWithoutVoids) {
  const MeshDomain domain(drawn({"###", "###"}), {});
  EXPECT_TRUE(domain.is_whole());
  EXPECT_EQ(domain.triangles(), 4);
  EXPECT_EQ(domain.square(1, 0), MeshSquare::whole);
  EXPECT_EQ(domain.square(2, 0), MeshSquare::none);
  EXPECT_FALSE(domain.is_rim({1, 1}));
}

TEST(MeshDomain, HalvesSquaresThatLackACorner) {
  const MeshDomain domain(drawn({"#####", "#####", "##.##", "#####", "#####"}), {});
  EXPECT_EQ(domain.triangles(), 12 * 2 + 4);
  EXPECT_EQ(domain.known_cells(), 24);
  EXPECT_EQ(domain.left_out_cells(), 0);
  EXPECT_EQ(domain.square(1, 1), MeshSquare::without_se);
  EXPECT_EQ(domain.square(2, 1), MeshSquare::without_sw);
  EXPECT_EQ(domain.square(1, 2), MeshSquare::without_ne);
  EXPECT_EQ(domain.square(2, 2), MeshSquare::without_nw);
  EXPECT_FALSE(domain.holds({2, 2}));
  EXPECT_TRUE(domain.is_rim({1, 2}));
  EXPECT_FALSE(domain.is_rim({0, 2}));
  EXPECT_TRUE(domain.holds_step({2, 1}, {3, 1}));
  EXPECT_FALSE(domain.holds_step({2, 2}, {3, 2}));
  EXPECT_TRUE(domain.holds_triangle({1, 1}, {2, 1}, {1, 2}));
  EXPECT_FALSE(domain.holds_triangle({2, 1}, {3, 2}, {1, 2}));
}

TEST(MeshDomain, LeavesTheSmallerOfTwoPiecesThatTouchInAPoint) {
  const MeshDomain domain(drawn({"##...", "##...", "..###", "..###", "..###"}), {});
  EXPECT_EQ(domain.triangles(), 2 + 8) << "they are apart";
  const MeshDomain touching(drawn({"###..", "###..", "#####", "..###", "..###"}), {});
  EXPECT_EQ(touching.left_out_cells(), 0);
  const MeshDomain pinched(drawn({"##..", "##..", ".###", ".###"}), {});
  EXPECT_EQ(pinched.triangles(), 1 + 2 + 1 + 4) << "round the corner they are one";
  const MeshDomain point(drawn({"###....", "###....", "###....", "..#####", "..#####"}), {});
  EXPECT_EQ(point.known_cells() - point.left_out_cells(), 19);
}

/// All triangulations of rims and any other cells of the domain are inside or outside as a whole: areas add up.
TEST(MeshDomain, IsCutAlongEdgesByEveryTriangulationOfItsRims) {
  for (const uint64_t seed : {1, 2, 3, 4, 5}) {
    HeightField heights(GridFrame::centred(40, 33, 1), 1.0F);
    make_holes(heights, seed, 0.03 * static_cast<double>(seed));
    const MeshDomain domain(heights, {});
    Rng rng(Seed{seed}.derive("cells"));
    std::vector<LatticePoint> cells;
    for (int y = 0; y < 33; ++y)
      for (int x = 0; x < 40; ++x)
        if (domain.holds({x, y}) && (domain.is_rim({x, y}) || x % 39 == 0 || y % 32 == 0 || rng.uniform() < 0.1))
          cells.push_back({x, y});
    int64_t area2 = 0;
    for (const auto& [a, b, c] : delaunay(cells, {})) {
      const LatticePoint p = cells[static_cast<size_t>(a)], q = cells[static_cast<size_t>(b)],
                         r = cells[static_cast<size_t>(c)];
      if (domain.holds_triangle(p, q, r)) area2 += orientation(p, q, r);
    }
    EXPECT_EQ(area2, domain.triangles());
  }
}

}  // namespace
}  // namespace seamount::geom

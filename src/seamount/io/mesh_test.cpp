#include "seamount/io/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

std::array<double, 3> corner(const TerrainMesh& mesh, size_t index) {
  const size_t v = 3 * size_t{mesh.indices[index]};
  return {mesh.positions[v], mesh.positions[v + 1], mesh.positions[v + 2]};
}

/// Six times the volume that a closed mesh encloses; positive if triangles face outwards.
double volume6(const TerrainMesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

/// Area of the mesh seen from above; triangles that face down count negative.
double plan_area(const TerrainMesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
    sum += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return sum;
}

std::set<std::array<float, 3>> border_positions(const TerrainMesh& mesh, double x_limit, double y_limit) {
  std::set<std::array<float, 3>> border;
  for (size_t v = 0; v < mesh.vertex_count(); ++v) {
    const std::array<float, 3> p{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
    if (std::abs(p[0]) > x_limit - 1e-3 || std::abs(p[1]) > y_limit - 1e-3) border.insert(p);
  }
  return border;
}

TEST(Mesh, HasEveryCellCentreOnce) {
  const HeightField heights = test_terrain(GridFrame::centred(9, 5, 10));
  const TerrainMesh mesh = make_mesh(heights, {}, {});
  EXPECT_EQ(mesh.vertex_count(), 45U);
  EXPECT_EQ(mesh.triangle_count(), 64U);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 9; ++x) {
      const size_t v = static_cast<size_t>(9 * y + x);
      EXPECT_EQ(mesh.positions[3 * v], heights.frame().x(x));
      EXPECT_EQ(mesh.positions[3 * v + 1], heights.frame().y(y));
      EXPECT_EQ(mesh.positions[3 * v + 2], heights(x, y));
      EXPECT_GT(mesh.normals[3 * v + 2], 0);
    }
  }
  EXPECT_NEAR(plan_area(mesh), 80 * 40, 1e-6);
}

TEST(Mesh, SimplifiesAndKeepsTheBorder) {
  HeightField heights = test_terrain(GridFrame::centred(128, 96, 10));
  for (float& z : heights.cells()) z = std::floor(z / 100) * 100;
  const TerrainMesh full = make_mesh(heights, {}, {});
  const TerrainMesh mesh = make_mesh(heights, {.max_triangles = 4000}, {});
  EXPECT_LE(mesh.triangle_count(), 4200U);
  EXPECT_GE(mesh.triangle_count(), 2000U);
  EXPECT_NEAR(plan_area(mesh), 1270.0 * 950.0, 1.0);
  EXPECT_EQ(border_positions(mesh, 635, 475), border_positions(full, 635, 475));
  EXPECT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()), mesh.vertex_count());
}

TEST(Mesh, ThinsHugeGridsEvenly) {
  const TerrainMesh mesh = make_mesh(test_terrain(GridFrame::centred(401, 401, 1)), {.max_triangles = 1000}, {});
  EXPECT_LE(mesh.triangle_count(), 1300U);
  EXPECT_NEAR(plan_area(mesh), 160000, 1);
}

TEST(Mesh, SolidsAreWatertightAndOutwards) {
  const HeightField heights = test_terrain(GridFrame::centred(40, 30, 10));
  for (const int64_t triangles : {int64_t{0}, int64_t{600}}) {
    const TerrainMesh mesh = make_mesh(heights, {.max_triangles = triangles, .base_m = 50}, {});
    std::map<std::array<double, 6>, int> edges;  // by position: walls have vertices of their own
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      for (size_t k = 0; k < 3; ++k) {
        const auto a = corner(mesh, i + k), b = corner(mesh, i + (k + 1) % 3);
        ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
        --edges[{b[0], b[1], b[2], a[0], a[1], a[2]}];
      }
    }
    for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0);
    EXPECT_GT(volume6(mesh), 6.0 * 390 * 290 * 50);
  }
}

TEST(Mesh, RefusesNonsense) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(4, 4, 1));
  EXPECT_THROW(make_mesh(test_terrain(GridFrame::centred(1, 9, 1)), {}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(heights, {.vertical_scale = 0}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(heights, {.max_triangles = -1}, {}), InvalidArgument);
  EXPECT_THAT(error_of([&] { write_mesh(heights, folder("x.gbl"), {}, {}); }), HasSubstr("did you mean '.glb'"));
}

}  // namespace
}  // namespace seamount::io

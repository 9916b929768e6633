#include "seamount/geom/mesh/terrain_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

/// A cone above the sea with rough cells, not symmetric in any way.
HeightField rough_cone(const GridFrame& frame) {
  HeightField heights(frame);
  Rng rng(Seed{1}.derive("terrain"));
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double r = std::hypot(x - 0.4 * frame.width, y - 0.6 * frame.height) / frame.width;
      heights(x, y) = static_cast<float>(900.0 - 2500.0 * r + rng.uniform(-20, 20));
    }
  }
  return heights;
}

MeshPart ground(const HeightField& heights, const MeshOptions& options) {
  return make_mesh(heights, options, {}).parts.at(0);
}

std::array<double, 3> corner(const MeshPart& mesh, size_t index) {
  const size_t v = 3 * size_t{mesh.indices[index]};
  return {mesh.positions[v], mesh.positions[v + 1], mesh.positions[v + 2]};
}

/// Six times the volume that a closed mesh encloses; positive if triangles face outwards.
double volume6(const MeshPart& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

/// Area of the mesh seen from above; triangles that face down count negative.
double plan_area(const MeshPart& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
    sum += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return sum;
}

std::set<std::array<float, 3>> border_positions(const MeshPart& mesh, double x_limit, double y_limit) {
  std::set<std::array<float, 3>> border;
  for (size_t v = 0; v < mesh.vertex_count(); ++v) {
    const std::array<float, 3> p{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
    if (std::abs(p[0]) > x_limit - 1e-3 || std::abs(p[1]) > y_limit - 1e-3) border.insert(p);
  }
  return border;
}

TEST(TerrainMesh, HasEveryCellCentreOnce) {
  const HeightField heights = rough_cone(GridFrame::centred(9, 5, 10));
  const MeshPart mesh = ground(heights, {});
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

TEST(TerrainMesh, SimplifiesAndKeepsTheBorder) {
  HeightField heights = rough_cone(GridFrame::centred(128, 96, 10));
  for (float& z : heights.cells()) z = std::floor(z / 100) * 100;
  const MeshPart full = ground(heights, {});
  const MeshPart mesh = ground(heights, {.max_triangles = 4000});
  EXPECT_LE(mesh.triangle_count(), 4200U);
  EXPECT_GE(mesh.triangle_count(), 2000U);
  EXPECT_NEAR(plan_area(mesh), 1270.0 * 950.0, 1.0);
  EXPECT_EQ(border_positions(mesh, 635, 475), border_positions(full, 635, 475));
  EXPECT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()), mesh.vertex_count());
}

TEST(TerrainMesh, ThinsHugeGridsEvenly) {
  const MeshPart mesh = ground(rough_cone(GridFrame::centred(401, 401, 1)), {.max_triangles = 1000});
  EXPECT_LE(mesh.triangle_count(), 1300U);
  EXPECT_NEAR(plan_area(mesh), 160000, 1);
}

TEST(TerrainMesh, SolidsAreWatertightAndOutwards) {
  const HeightField heights = rough_cone(GridFrame::centred(40, 30, 10));
  for (const int64_t triangles : {int64_t{0}, int64_t{600}}) {
    const MeshPart mesh = ground(heights, {.max_triangles = triangles, .base_m = 50});
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

TEST(TerrainMesh, SaysWhereItLiesInTheWorld) {
  const Mesh mesh = make_mesh(HeightField({31, 21, 10, 5000, 7000, "EPSG:32604"}, 5.0F), {.vertical_scale = 2}, {});
  EXPECT_EQ(mesh.origin, (Vec2{5155, 6895}));
  EXPECT_EQ(mesh.crs, "EPSG:32604");
  EXPECT_EQ(mesh.vertical_scale, 2.0);
  EXPECT_EQ(mesh.parts.size(), 1U) << "no water above the sea";
  EXPECT_EQ(mesh.parts[0].positions[2], 10.0F);
}

TEST(TerrainMesh, WaterLiesOverAllAtSeaLevelAndFacesUp) {
  const HeightField heights = rough_cone(GridFrame::centred(30, 20, 10));
  EXPECT_EQ(make_mesh(heights, {.water = false}, {}).parts.size(), 1U);
  const Mesh mesh = make_mesh(heights, {}, {});
  ASSERT_EQ(mesh.parts.size(), 2U);
  const MeshPart& water = mesh.parts[1];
  EXPECT_EQ(water.material, MeshMaterial::water);
  EXPECT_TRUE(water.uvs.empty());
  for (size_t i = 0; i < water.positions.size(); i += 3) {
    EXPECT_EQ(std::abs(water.positions[i]), 145.0F);
    EXPECT_EQ(std::abs(water.positions[i + 1]), 95.0F);
    EXPECT_EQ(water.positions[i + 2], 0.0F);
    EXPECT_EQ(water.normals[i + 2], 1.0F);
  }
  EXPECT_EQ(plan_area(water), 290.0 * 190.0);
}

TEST(TerrainMesh, RefusesNonsense) {
  HeightField heights = rough_cone(GridFrame::centred(4, 4, 1));
  EXPECT_THROW(make_mesh(rough_cone(GridFrame::centred(1, 9, 1)), {}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(heights, {.vertical_scale = 0}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(heights, {.max_triangles = -1}, {}), InvalidArgument);
  heights(2, 2) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(make_mesh(heights, {}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom

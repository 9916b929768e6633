#include "seamount/geom/mesh/terrain_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/geom/mesh/test_surface.h"

namespace seamount::geom {
namespace {

MeshPart ground(const HeightField& heights, const MeshOptions& options) {
  return make_mesh(heights, options, {}).parts.at(0);
}

/// Three sizes, whole and with holes: few, many small ones, nearly nothing left.
std::vector<HeightField> terrains(uint64_t seed) {
  std::vector<HeightField> all;
  for (const auto& [width, height] : {std::pair{97, 140}, {601, 41}, {2, 70}, {33, 2}, {150, 161}}) {
    for (const double single : {-1.0, 0.0, 0.02, 0.4}) {
      all.push_back(rough_cone(GridFrame::centred(width, height, 7.3), seed));
      if (single >= 0) make_holes(all.back(), seed, single);
    }
  }
  return all;
}

/// Is there a square of three known cells, so that there is a mesh?
bool has_ground(const HeightField& heights) {
  for (int y = 0; y + 1 < heights.height(); ++y) {
    for (int x = 0; x + 1 < heights.width(); ++x) {
      int known = 0;
      for (const int k : {0, 1, 2, 3}) known += !std::isnan(heights(x + k % 2, y + k / 2));
      if (known >= 3) return true;
    }
  }
  return false;
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
  EXPECT_NEAR(faults_of(mesh).plan_area, 80 * 40, 1e-6);
}

TEST(TerrainMesh, IsASurfaceThatFacesUpHoweverItIsMade) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const HeightField& heights : terrains(seed)) {
      if (!has_ground(heights)) continue;
      const double area = faults_of(ground(heights, {})).plan_area;
      for (const MeshOptions& options :
           {MeshOptions{}, {.max_triangles = 700}, {.max_error_m = 30}, {.max_triangles = 5000, .max_error_m = 3}}) {
        const SurfaceFaults faults = faults_of(ground(heights, options));
        EXPECT_EQ(faults.facing_down, 0);
        EXPECT_EQ(faults.without_area, 0);
        EXPECT_EQ(faults.doubled_edges, 0);
        EXPECT_EQ(faults.pinched_corners, 0);
        EXPECT_NEAR(faults.plan_area, area, 0.1) << "covers what all cells do";
      }
    }
  }
}

TEST(TerrainMesh, CoversTheRectangleOfTheCentres) {
  const HeightField heights = rough_cone(GridFrame::centred(401, 301, 1));
  for (const int64_t triangles : {2, 10, 100, 1000, 10000})
    EXPECT_NEAR(faults_of(ground(heights, {.max_triangles = triangles})).plan_area, 120000, 0.1);
}

TEST(TerrainMesh, TellsTheTrueError) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const HeightField& heights : terrains(seed)) {
      if (!has_ground(heights)) continue;
      for (const MeshOptions& options : {MeshOptions{}, {.max_triangles = 700}, {.max_error_m = 30}}) {
        const Mesh mesh = make_mesh(heights, options, {});
        double largest = 0, squares = 0;
        int64_t cells = 0;
        const Grid<double> errors = errors_of(mesh.parts[0], heights);
        for (const double error : errors.cells()) {
          if (std::isnan(error)) continue;
          largest = std::max(largest, error);
          squares += error * error;
          ++cells;
        }
        EXPECT_NEAR(mesh.largest_error_m, largest, 1e-9);
        EXPECT_NEAR(mesh.rms_error_m, std::sqrt(squares / static_cast<double>(cells)), 1e-9);
        if (options.max_error_m > 0) {
          EXPECT_LE(largest, options.max_error_m);
        }
      }
    }
  }
}

TEST(TerrainMesh, UsesTheTrianglesThatItMay) {
  const HeightField heights = rough_cone(GridFrame::centred(800, 700, 10));
  double last = 1e9;
  for (const int64_t most : {300, 3000, 30000, 300000}) {
    const Mesh mesh = make_mesh(heights, {.max_triangles = most}, {});
    EXPECT_LE(mesh.parts[0].triangle_count(), static_cast<size_t>(most));
    EXPECT_GE(mesh.parts[0].triangle_count(), static_cast<size_t>(most - most / 100 - 2));
    EXPECT_LT(mesh.largest_error_m, last);
    last = mesh.largest_error_m;
  }
}

TEST(TerrainMesh, KeepsTheHighestAndTheLowestCell) {
  for (const uint64_t seed : {1, 2, 3}) {
    HeightField heights = rough_cone(GridFrame::centred(700, 300, 10), seed, 0.0);
    heights(411, 77) = 5000;
    heights(699, 200) = -4000;  // on the border
    const MeshPart mesh = ground(heights, {.max_triangles = 40});
    float low = 0, high = 0;
    for (size_t i = 2; i < mesh.positions.size(); i += 3)
      low = std::min(low, mesh.positions[i]), high = std::max(high, mesh.positions[i]);
    EXPECT_EQ(high, 5000);
    EXPECT_EQ(low, -4000);
  }
}

TEST(TerrainMesh, AFlatTerrainNeedsFewTriangles) {
  const HeightField flat(GridFrame::centred(2000, 1500, 10), 3.0F);
  EXPECT_LT(ground(flat, {.max_triangles = 100000}).triangle_count(), 10000U);
  EXPECT_LT(ground(flat, {.max_error_m = 1}).triangle_count(), 3000U);
}

TEST(TerrainMesh, IsTheSameOnAnyNumberOfThreads) {
  HeightField heights = rough_cone(GridFrame::centred(1500, 1300, 10));
  make_holes(heights, 5, 0.0001);
  const Mesh one = make_mesh(heights, {.max_triangles = 60000}, {.threads = 1});
  EXPECT_EQ(one, make_mesh(heights, {.max_triangles = 60000}, {.threads = 3}));
  EXPECT_GE(one.parts[0].triangle_count(), 59870U);
}

TEST(TerrainMesh, TellsProgressAndIsCancelled) {
  const HeightField heights = rough_cone(GridFrame::centred(900, 900, 10));
  double last = 0;
  RunContext run;
  run.progress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  make_mesh(heights, {.max_triangles = 20000}, run);
  EXPECT_EQ(last, 1.0);
  const std::atomic<bool> stop = true;
  EXPECT_THROW(make_mesh(heights, {.max_triangles = 20000}, {.cancelled = &stop}), Cancelled);
}

TEST(TerrainMesh, HolesAreOpenAndCellsOutsideOfThemCovered) {
  HeightField heights = rough_cone(GridFrame::centred(120, 90, 10));
  for (int y = 30; y < 50; ++y)
    for (int x = 40; x < 70; ++x) heights(x, y) = std::nanf("");
  std::vector<std::string> said;
  const Mesh mesh =
      make_mesh(heights, {.max_triangles = 2000}, {.note = [&](const std::string& l) { said.push_back(l); }});
  EXPECT_NEAR(faults_of(mesh.parts[0]).plan_area, 100 * (119 * 89 - 31 * 21 + 2), 1e-3) << "half of each corner";
  const Grid<double> errors = errors_of(mesh.parts[0], heights);
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x) EXPECT_EQ(std::isnan(errors(x, y)), std::isnan(heights(x, y)));
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0], "600 cells without a height are holes in the mesh");
  EXPECT_EQ(said[1].substr(0, 10), "mesh of 19");
}

TEST(TerrainMesh, SolidsAreClosedAndOutwards) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const HeightField& heights : terrains(seed)) {
      if (!has_ground(heights)) continue;
      for (const MeshOptions& options : {MeshOptions{.base_m = 50}, {.max_triangles = 900, .base_m = 2.5}}) {
        const Mesh mesh = make_mesh(heights, options, {});
        ASSERT_EQ(mesh.parts.size(), 1U) << "no sheet of water, which is open";
        const SurfaceFaults faults = faults_of(mesh.parts[0]);
        EXPECT_EQ(faults.open_edges, 0);
        EXPECT_EQ(faults.doubled_edges, 0);
        const double area = faults_of(ground(heights, {.max_triangles = options.max_triangles})).plan_area;
        EXPECT_GT(faults.volume, 0.999 * area * options.base_m);
        EXPECT_NEAR(faults.plan_area, 0, 1e-3) << "the floor is as large as the ground";
      }
    }
  }
}

TEST(TerrainMesh, FloorsHaveNoFans) {
  const MeshPart mesh = ground(rough_cone(GridFrame::centred(600, 500, 10)), {.base_m = 50});
  std::vector<int> uses(mesh.vertex_count());
  for (const uint32_t v : mesh.indices) ++uses[v];
  EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 40);
}

TEST(TerrainMesh, TilesOfAnyLevelsFitWithoutCracks) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const bool holes : {false, true}) {
      HeightField heights = rough_cone({250, 160, 30.87, 512345.6, 2100000.3, "EPSG:32604"}, seed);
      if (holes) make_holes(heights, seed, 0.001);
      for (const MeshOptions& options :
           {MeshOptions{.max_triangles = 10000}, {.max_error_m = 9}, {.max_triangles = 15000, .max_error_m = 15}, {}}) {
        std::vector<MeshTile> tiles;
        make_mesh_tiles(heights, options, {.across = 3, .levels = 3},
                        [&](const MeshTile& tile) { tiles.push_back(tile); }, {});
        const SurfaceFaults whole = faults_of(ground(heights, {}));
        std::array<size_t, 3> triangles{};
        for (const MeshTile& tile : tiles)
          triangles[static_cast<size_t>(tile.level)] += tile.mesh.parts[0].triangle_count();
        for (const int pattern : {0, 1, 2, 3}) {  // all of the finest, all coarse, and mixed in two ways
          std::vector<const Mesh*> together;
          for (const MeshTile& tile : tiles) {
            const std::array<int, 4> level{0, 2, (tile.column + tile.row) % 3, (tile.column + 2 * tile.row + 1) % 3};
            if (tile.level == level[static_cast<size_t>(pattern)]) together.push_back(&tile.mesh);
          }
          const SurfaceFaults faults = faults_of(together);
          EXPECT_EQ(faults.facing_down + faults.without_area + faults.doubled_edges, 0);
          EXPECT_NEAR(faults.open_length, whole.open_length, 1e-6 * whole.open_length);
          EXPECT_NEAR(faults.plan_area, whole.plan_area, 1e-6 * whole.plan_area);
        }
        EXPECT_LT(triangles[1], 0.8 * static_cast<double>(triangles[0]));
        EXPECT_LT(triangles[2], triangles[1]);
        if (options.max_triangles > 0) {
          EXPECT_LE(triangles[0], static_cast<size_t>(options.max_triangles));
        }
      }
    }
  }
}

TEST(TerrainMesh, TilesTellTheirOwnErrorAndPlace) {
  const HeightField heights = rough_cone(GridFrame::centred(300, 200, 30.87));
  int count = 0;
  make_mesh_tiles(heights, {.max_triangles = 3000}, {.across = 4, .levels = 2},
                  [&](const MeshTile& tile) {
                    const Grid<double> errors = errors_of(tile.mesh.parts[0], heights, tile.mesh.offset);
                    double largest = 0;
                    for (const double error : errors.cells())
                      largest = std::max(largest, std::isnan(error) ? 0 : error);
                    EXPECT_NEAR(tile.mesh.largest_error_m, largest, 1e-9);
                    EXPECT_GE(tile.mesh.offset.x, -0.5 * 300 * 30.87);
                    EXPECT_EQ(tile.mesh.origin, Vec2{});
                    ++count;
                  },
                  {});
  EXPECT_EQ(count, 4 * 3 * 2);
  EXPECT_THROW(make_mesh_tiles(heights, {.base_m = 1}, {}, {}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh_tiles(heights, {}, {.across = 0}, {}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh_tiles(heights, {}, {.levels = 0}, {}, {}), InvalidArgument);
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
  EXPECT_EQ(faults_of(water).plan_area, 290.0 * 190.0);
}

TEST(TerrainMesh, WaterLeavesDryBasinsOut) {
  // A sea of three columns in the west, and a basin of 10 x 8 cells behind land.
  HeightField heights(GridFrame::centred(30, 20, 10), 40.0F);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 30; ++x) {
      if (x < 3) heights(x, y) = -5.0F;
      if (x >= 12 && x < 22 && y >= 6 && y < 14) heights(x, y) = -60.0F;
    }
  }
  Grid<uint8_t> hollows(heights.frame());
  for (size_t i = 0; i < heights.size(); ++i) hollows.data()[i] = heights.data()[i] == -60.0F ? 1 : 0;
  const MeshOptions options{.hollows = &hollows};
  const Mesh mesh = make_mesh(heights, options, {});
  ASSERT_EQ(mesh.parts.size(), 2U);
  EXPECT_EQ(faults_of(mesh.parts[1]).plan_area, 290.0 * 190.0 - 110.0 * 90.0);
  int sheets = 0;
  const auto count = [&](const MeshTile& tile) { sheets += tile.mesh.parts.size() == 2 ? 1 : 0; };
  make_mesh_tiles(heights, options, {.across = 3}, count, {});
  EXPECT_EQ(sheets, 2);  // the two in the west
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 3; ++x) heights(x, y) = 40.0F;
  EXPECT_EQ(make_mesh(heights, options, {}).parts.size(), 1U);
}

TEST(TerrainMesh, RefusesNonsense) {
  HeightField heights = rough_cone(GridFrame::centred(4, 4, 1));
  EXPECT_THROW(make_mesh(rough_cone(GridFrame::centred(1, 9, 1)), {}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(heights, {.vertical_scale = 0}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(heights, {.max_triangles = -1}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(heights, {.max_error_m = -1}, {}), InvalidArgument);
  heights(2, 2) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(make_mesh(heights, {}, {}), InvalidArgument);
  EXPECT_THROW(make_mesh(HeightField(GridFrame::centred(9, 9, 1), std::nanf("")), {}, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom

#include "seamount/io/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "seamount/io/image_file.h"
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

/// A GLB file taken apart as the specification says.
struct Glb {
  nlohmann::json json;
  std::vector<uint8_t> bin;

  explicit Glb(const std::string& path) {
    const std::vector<uint8_t> file = read_file(path);
    const auto word = [&](size_t at) {
      uint32_t value = 0;
      std::memcpy(&value, file.data() + at, 4);
      return size_t{value};
    };
    EXPECT_EQ(word(0), 0x46546C67U);
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), file.size());
    EXPECT_EQ(word(12) % 4, 0U);
    EXPECT_EQ(word(16), 0x4E4F534AU);
    json = nlohmann::json::parse(file.begin() + 20, file.begin() + 20 + static_cast<ptrdiff_t>(word(12)));
    const size_t bin_at = 20 + word(12);
    EXPECT_EQ(word(bin_at + 4), 0x004E4942U);
    EXPECT_EQ(bin_at + 8 + word(bin_at), file.size());
    bin.assign(file.begin() + static_cast<ptrdiff_t>(bin_at) + 8, file.end());
    EXPECT_EQ(json["buffers"][0]["byteLength"], bin.size());
  }

  template <class T>
  std::vector<T> values(size_t accessor, size_t components) const {
    const auto& a = json["accessors"][accessor];
    const auto& view = json["bufferViews"][a["bufferView"].get<size_t>()];
    std::vector<T> result(a["count"].get<size_t>() * components);
    EXPECT_EQ(view["byteLength"], result.size() * sizeof(T));
    EXPECT_EQ(view["byteOffset"].get<size_t>() % 4, 0U);
    EXPECT_LE(view["byteOffset"].get<size_t>() + view["byteLength"].get<size_t>(), bin.size());
    std::memcpy(result.data(), bin.data() + view["byteOffset"].get<size_t>(), result.size() * sizeof(T));
    return result;
  }
};

TEST(MeshFiles, GlbIsValid) {
  const TestFolder folder;
  const HeightField heights = test_terrain({31, 21, 10, 5000, 7000, "EPSG:32604"});
  Image texture(31, 21, {200, 180, 140});
  texture.pixel(3, 4)[0] = 7;
  write_mesh(heights, folder("t.glb"), {.texture = &texture}, {});
  const Glb glb(folder("t.glb"));
  const auto& primitives = glb.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2U) << "terrain and water";
  for (const auto& primitive : primitives) {
    const size_t position = primitive["attributes"]["POSITION"];
    const std::vector<float> places = glb.values<float>(position, 3);
    const std::vector<float> normals = glb.values<float>(primitive["attributes"]["NORMAL"], 3);
    ASSERT_EQ(places.size(), normals.size());
    for (size_t k = 0; k < 3; ++k) {
      float low = places[k], high = places[k];
      for (size_t i = k; i < places.size(); i += 3) low = std::min(low, places[i]), high = std::max(high, places[i]);
      EXPECT_EQ(glb.json["accessors"][position]["min"][k], low);
      EXPECT_EQ(glb.json["accessors"][position]["max"][k], high);
    }
    for (size_t i = 0; i < normals.size(); i += 3)
      EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1, 1e-5);
    const std::vector<uint32_t> indices = glb.values<uint32_t>(primitive["indices"], 1);
    for (size_t i = 0; i < indices.size(); i += 3) {
      for (size_t k = 0; k < 3; ++k) ASSERT_LT(indices[i + k], places.size() / 3);
      const float* a = &places[3 * indices[i]];
      const float* b = &places[3 * indices[i + 1]];
      const float* c = &places[3 * indices[i + 2]];
      EXPECT_GT((b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]), 0) << "faces up (y)";
    }
  }
  const auto& image = glb.json["images"][0];
  const auto& view = glb.json["bufferViews"][image["bufferView"].get<size_t>()];
  const auto bytes = std::span(glb.bin).subspan(view["byteOffset"], view["byteLength"]);
  EXPECT_EQ(read_image(bytes, "texture"), texture);
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["crs"], "EPSG:32604");
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["origin_x_m"], 5155.0);
  EXPECT_EQ(glb.json["materials"][1]["alphaMode"], "BLEND");
}

TEST(MeshFiles, PlainGlbHasNoTextureAndNoWater) {
  const TestFolder folder;
  write_mesh(HeightField(GridFrame::centred(4, 4, 1), 5.0F), folder("t.glb"), {}, {});
  const Glb glb(folder("t.glb"));
  EXPECT_EQ(glb.json["meshes"][0]["primitives"].size(), 1U);
  EXPECT_FALSE(glb.json.contains("images"));
}

TEST(MeshFiles, StlAndPlyHaveTheRightLength) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(11, 6, 10));
  write_mesh(heights, folder("t.stl"), {}, {});
  EXPECT_EQ(read_file(folder("t.stl")).size(), 84U + 50U * 100U);
  write_mesh(heights, folder("t.ply"), {}, {});
  const std::vector<uint8_t> ply = read_file(folder("t.ply"));
  const std::string text(ply.begin(), ply.end());
  EXPECT_THAT(text, HasSubstr("element vertex 66\n"));
  EXPECT_EQ(ply.size() - text.find("end_header\n") - 11, 66U * 24U + 100U * 13U);
}

TEST(MeshFiles, ObjCanBeReadAgain) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(6, 4, 10));
  const Image texture(6, 4, {1, 2, 3});
  write_mesh(heights, folder("t.obj"), {.texture = &texture}, {});
  const std::vector<uint8_t> bytes = read_file(folder("t.obj"));
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_EQ(std::count(text.begin(), text.end(), 'f'), 30 + 0) << "30 faces";
  EXPECT_THAT(text, HasSubstr("mtllib t.mtl\n"));
  EXPECT_EQ(read_image(folder("t.png")), texture);
  EXPECT_EQ(folder.files(), 3U);
}

}  // namespace
}  // namespace seamount::io

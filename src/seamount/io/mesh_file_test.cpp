#include "seamount/io/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "seamount/io/image_file.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

/// A tent of six vertices and four triangles, and water beside it. Its sizes are odd, so that nothing is aligned by
/// chance.
Mesh tent() {
  MeshPart ground{.material = MeshMaterial::ground,
                  .positions = {-10, 7, -1.5, -10, -7, -2, 0, 7, 3.25, 0, -7, 4, 10, 7, -1, 10, -7, -0.125},
                  .normals = {},
                  .uvs = {},
                  .indices = {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5}};
  for (size_t v = 0; v < 6; ++v) {
    const std::array<float, 3> normal = v == 2 || v == 3 ? std::array{0.0F, 0.0F, 1.0F} : std::array{0.0F, 0.6F, 0.8F};
    ground.normals.insert(ground.normals.end(), normal.begin(), normal.end());
    ground.uvs.insert(ground.uvs.end(), {0.5F * static_cast<float>(v / 2), v % 2 == 0 ? 0.0F : 1.0F});
  }
  MeshPart water{.material = MeshMaterial::water,
                 .positions = {-10, 7, 0, -10, -7, 0, 10, -7, 0, 10, 7, 0},
                 .normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
                 .uvs = {},
                 .indices = {0, 1, 2, 0, 2, 3}};
  return {.parts = {ground, water}, .origin = {5155, 6895}, .crs = "EPSG:32604", .vertical_scale = 2.0};
}

std::string text_of(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return {bytes.begin(), bytes.end()};
}

/// (x, y, z) of each vertex with y up as x east, y north, z up.
std::vector<float> z_up(const std::vector<float>& y_up) {
  std::vector<float> turned;
  for (size_t i = 0; i < y_up.size(); i += 3) turned.insert(turned.end(), {y_up[i], -y_up[i + 2], y_up[i + 1]});
  return turned;
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

TEST(MeshFile, GlbHoldsAllParts) {
  const TestFolder folder;
  const Mesh mesh = tent();
  Image texture(31, 21, {200, 180, 140});
  texture.pixel(3, 4)[0] = 7;
  write_mesh(mesh, folder("t.glb"), {.texture = &texture});
  const Glb glb(folder("t.glb"));
  const auto& primitives = glb.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2U);
  for (size_t p = 0; p < 2; ++p) {
    const MeshPart& part = mesh.parts[p];
    const auto& attributes = primitives[p]["attributes"];
    const size_t position = attributes["POSITION"];
    const std::vector<float> places = glb.values<float>(position, 3);
    EXPECT_EQ(z_up(places), part.positions);
    EXPECT_EQ(z_up(glb.values<float>(attributes["NORMAL"], 3)), part.normals);
    EXPECT_EQ(glb.values<uint32_t>(primitives[p]["indices"], 1), part.indices);
    EXPECT_EQ(attributes.contains("TEXCOORD_0"), !part.uvs.empty());
    if (!part.uvs.empty()) {
      EXPECT_EQ(glb.values<float>(attributes["TEXCOORD_0"], 2), part.uvs);
    }
    for (size_t k = 0; k < 3; ++k) {
      float low = places[k], high = places[k];
      for (size_t i = k; i < places.size(); i += 3) low = std::min(low, places[i]), high = std::max(high, places[i]);
      EXPECT_EQ(glb.json["accessors"][position]["min"][k], low);
      EXPECT_EQ(glb.json["accessors"][position]["max"][k], high);
    }
  }
  const auto& image = glb.json["images"][0];
  const auto& view = glb.json["bufferViews"][image["bufferView"].get<size_t>()];
  const auto bytes = std::span(glb.bin).subspan(view["byteOffset"], view["byteLength"]);
  EXPECT_EQ(read_image(bytes, "texture"), texture);
  const auto& extras = glb.json["nodes"][0]["extras"];
  EXPECT_EQ(extras["crs"], "EPSG:32604");
  EXPECT_EQ(extras["origin_x_m"], 5155.0);
  EXPECT_EQ(extras["origin_y_m"], 6895.0);
  EXPECT_EQ(extras["vertical_scale"], 2.0);
  EXPECT_EQ(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  EXPECT_EQ(glb.json["materials"][1]["alphaMode"], "BLEND");
}

TEST(MeshFile, PlainGlbHasNoTextureAndNoWater) {
  const TestFolder folder;
  Mesh mesh = tent();
  mesh.parts.pop_back();
  write_mesh(mesh, folder("t.glb"));
  const Glb glb(folder("t.glb"));
  EXPECT_EQ(glb.json["meshes"][0]["primitives"].size(), 1U);
  EXPECT_FALSE(glb.json.contains("images"));
}

TEST(MeshFile, StlHoldsTheGroundsCornersAndTrueNormals) {
  const TestFolder folder;
  const MeshPart ground = tent().parts[0];
  write_mesh(tent(), folder("t.stl"));
  const std::vector<uint8_t> stl = read_file(folder("t.stl"));
  ASSERT_EQ(stl.size(), 84U + 50U * 4U);
  uint32_t count = 0;
  std::memcpy(&count, stl.data() + 80, 4);
  EXPECT_EQ(count, 4U);
  for (size_t t = 0; t < 4; ++t) {
    std::array<float, 12> facet{};
    std::memcpy(facet.data(), stl.data() + 84 + 50 * t, sizeof(facet));
    for (size_t k = 0; k < 9; ++k)
      EXPECT_EQ(facet[3 + k], ground.positions[3 * size_t{ground.indices[3 * t + k / 3]} + k % 3]);
    EXPECT_NEAR(std::hypot(facet[0], facet[1], facet[2]), 1, 1e-6);
    EXPECT_GT(facet[2], 0) << "up";
    for (size_t k = 1; k < 3; ++k) {
      double along = 0;
      for (size_t c = 0; c < 3; ++c) along += facet[c] * (facet[3 + 3 * k + c] - facet[3 + c]);
      EXPECT_NEAR(along, 0, 1e-5) << "upright on its edges";
    }
  }
}

TEST(MeshFile, PlyHoldsTheGround) {
  const TestFolder folder;
  const MeshPart ground = tent().parts[0];
  write_mesh(tent(), folder("t.ply"));
  const std::string ply = text_of(folder("t.ply"));
  EXPECT_THAT(ply, HasSubstr("element vertex 6\n"));
  EXPECT_THAT(ply, HasSubstr("element face 4\n"));
  const size_t data = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size() - data, 6U * 24U + 4U * 13U);
  for (size_t v = 0; v < 6; ++v) {
    std::array<float, 6> vertex{};
    std::memcpy(vertex.data(), ply.data() + data + 24 * v, sizeof(vertex));
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(vertex[k], ground.positions[3 * v + k]);
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(vertex[3 + k], ground.normals[3 * v + k]);
  }
  for (size_t t = 0; t < 4; ++t) {
    const char* face = ply.data() + data + size_t{6} * 24 + 13 * t;
    std::array<uint32_t, 3> corners{};
    std::memcpy(corners.data(), face + 1, sizeof(corners));
    EXPECT_EQ(face[0], 3);
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(corners[k], ground.indices[3 * t + k]);
  }
}

TEST(MeshFile, ObjCanBeReadAgain) {
  const TestFolder folder;
  const MeshPart ground = tent().parts[0];
  const Image texture(6, 4, {1, 2, 3});
  write_mesh(tent(), folder("t.obj"), {.texture = &texture});
  std::vector<float> places, normals, uvs;
  std::vector<uint32_t> corners;
  std::istringstream obj(text_of(folder("t.obj")));
  for (std::string line; std::getline(obj, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    std::vector<float>* values = kind == "v" ? &places : (kind == "vn" ? &normals : (kind == "vt" ? &uvs : nullptr));
    for (float value = 0; values != nullptr && words >> value;) values->push_back(value);
    for (std::string corner; kind == "f" && words >> corner;) {
      const std::string number = corner.substr(0, corner.find('/'));
      EXPECT_EQ(corner, number + "/" + number + "/" + number);
      corners.push_back(static_cast<uint32_t>(std::stoul(number)) - 1);
    }
  }
  EXPECT_EQ(z_up(places), ground.positions);
  EXPECT_EQ(z_up(normals), ground.normals);
  for (size_t i = 1; i < uvs.size(); i += 2) uvs[i] = 1 - uvs[i];
  EXPECT_EQ(uvs, ground.uvs);
  EXPECT_EQ(corners, ground.indices);
  EXPECT_THAT(text_of(folder("t.obj")), HasSubstr("mtllib t.mtl\n"));
  EXPECT_THAT(text_of(folder("t.mtl")), HasSubstr("map_Kd t.png\n"));
  EXPECT_EQ(read_image(folder("t.png")), texture);
  EXPECT_EQ(folder.files(), 3U);
}

/// A tile of a terrain that lies off its middle, with a vertex twice: a hard edge.
Mesh off_tent() {
  Mesh mesh = tent();
  mesh.offset = {512, -96.5};
  mesh.largest_error_m = 1.75;
  mesh.rms_error_m = 0.25;
  MeshPart& part = mesh.parts[0];
  part.positions.insert(part.positions.end(), part.positions.begin(), part.positions.begin() + 3);
  part.normals.insert(part.normals.end(), {1, 0, 0});
  part.uvs.insert(part.uvs.end(), {0, 0});
  part.indices[0] = 6;
  part.hard_edges = true;
  return mesh;
}

TEST(MeshFile, GlbMovesATileByItsNode) {
  const TestFolder folder;
  write_mesh(off_tent(), folder("t.glb"));
  const Glb glb(folder("t.glb"));
  const auto& node = glb.json["nodes"][0];
  EXPECT_EQ(node["translation"], nlohmann::json({512.0, 0.0, 96.5}));
  EXPECT_EQ(node["extras"]["largest_error_m"], 1.75);
  EXPECT_EQ(node["extras"]["rms_error_m"], 0.25);
  EXPECT_EQ(glb.json["accessors"][0]["count"], 7);
  write_mesh(tent(), folder("middle.glb"));
  EXPECT_FALSE(Glb(folder("middle.glb")).json["nodes"][0].contains("translation"));
}

TEST(MeshFile, OtherFormatsHoldATileWhereItLiesAndShareItsPlaces) {
  const TestFolder folder;
  write_mesh(off_tent(), folder("t.obj"));
  const std::string obj = text_of(folder("t.obj"));
  EXPECT_THAT(obj, HasSubstr("\nv 502 -1.5 89.5\n"));
  EXPECT_THAT(obj, HasSubstr("\nf 1/7/7 2/2/2 3/3/3\n")) << "a place of the first vertex, the normal of the last";
  write_mesh(off_tent(), folder("t.ply"));
  const std::string ply = text_of(folder("t.ply"));
  EXPECT_THAT(ply, HasSubstr("element vertex 6\n"));
  std::array<float, 6> first{};
  std::memcpy(first.data(), ply.data() + ply.find("end_header\n") + 11, sizeof(first));
  EXPECT_EQ(first, (std::array<float, 6>{502, -89.5, -1.5, 0, 0.6F, 0.8F}));
  write_mesh(off_tent(), folder("t.stl"));
  std::array<float, 3> corner{};
  std::memcpy(corner.data(), text_of(folder("t.stl")).data() + 84 + 12, sizeof(corner));
  EXPECT_EQ(corner, (std::array<float, 3>{502, -89.5, -1.5}));
}

TEST(MeshFile, RefusesWhatItCannotWrite) {
  const TestFolder folder;
  EXPECT_THAT(error_of([&] { write_mesh(tent(), folder("x.gbl")); }), HasSubstr("did you mean '.glb'"));
  EXPECT_THAT(error_of([&] { write_mesh(Mesh{}, folder("x.glb")); }), HasSubstr("mesh: has no triangles"));
}

}  // namespace
}  // namespace seamount::io

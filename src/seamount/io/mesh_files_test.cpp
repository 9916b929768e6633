// Mesh files read again, each format by its own specification, and held against the terrain that they were written
// from: every vertex and its height, normals, texture coordinates, triangles, and what a solid encloses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "seamount/io/image_file.h"
#include "seamount/io/mesh.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;
using Vec3 = std::array<double, 3>;

/// What a file says, turned so that x is east, y north and z up.
struct ReadMesh {
  std::vector<Vec3> places, normals;  ///< per vertex; of STL per facet
  std::vector<std::array<double, 2>> uvs;
  std::vector<std::array<size_t, 3>> faces;
};

Vec3 z_up(const Vec3& y_up) { return {y_up[0], -y_up[2], y_up[1]}; }

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twice the area of a face along its normal, which looks to where its corners run counter-clockwise.
Vec3 face_normal(const ReadMesh& mesh, const std::array<size_t, 3>& face) {
  const Vec3 &a = mesh.places[face[0]], &b = mesh.places[face[1]], &c = mesh.places[face[2]];
  return cross(minus(b, a), minus(c, a));
}

/// Takes numbers of a binary file one after the other.
class Bytes {
 public:
  Bytes(std::vector<uint8_t> bytes, size_t at) : bytes_(std::move(bytes)), at_(at) {}
  template <class T>
  T take() {
    T value{};
    EXPECT_LE(at_ + sizeof(T), bytes_.size());
    if (at_ + sizeof(T) <= bytes_.size()) std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  Vec3 take_place() {
    const float x = take<float>(), y = take<float>(), z = take<float>();
    return {x, y, z};
  }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::vector<uint8_t> bytes_;
  size_t at_;
};

ReadMesh read_obj(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  ReadMesh mesh;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    Vec3 v{};
    if (word == "v" || word == "vn") {
      words >> v[0] >> v[1] >> v[2];
      (word == "v" ? mesh.places : mesh.normals).push_back(z_up(v));
    } else if (word == "vt") {
      words >> v[0] >> v[1];
      mesh.uvs.push_back({v[0], 1.0 - v[1]});
    } else if (word == "f") {
      std::array<size_t, 3> face{};
      for (size_t& corner : face) {
        size_t place = 0, uv = 0, normal = 0;
        char slash = 0;
        words >> place >> slash >> uv >> slash >> normal;
        EXPECT_TRUE(place >= 1 && place == uv && place == normal) << line;
        corner = place - 1;
      }
      mesh.faces.push_back(face);
    } else {
      EXPECT_TRUE(word == "#" || word == "mtllib" || word == "o" || word == "usemtl") << line;
      continue;
    }
    EXPECT_FALSE(words.fail()) << line;
  }
  return mesh;
}

ReadMesh read_ply(const std::string& path) {
  std::vector<uint8_t> file = read_file(path);
  const std::string text(file.begin(), file.end());
  const size_t end = text.find("end_header\n");
  EXPECT_EQ(text.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0U);
  const auto count = [&](const std::string& element) {
    const size_t at = text.find("element " + element + " ");
    return at < end ? std::stoul(text.substr(at + 9 + element.size())) : 0;
  };
  for (const char* property : {"float x\n", "float y\n", "float z\n", "float nx\n", "float ny\n", "float nz\n"})
    EXPECT_LT(text.find(std::string("property ") + property), end);
  const size_t vertices = count("vertex"), faces = count("face");
  Bytes bytes(std::move(file), end + 11);
  ReadMesh mesh;
  for (size_t i = 0; i < vertices; ++i) {
    mesh.places.push_back(bytes.take_place());
    mesh.normals.push_back(bytes.take_place());
  }
  for (size_t i = 0; i < faces; ++i) {
    EXPECT_EQ(bytes.take<uint8_t>(), 3);
    const auto a = bytes.take<uint32_t>(), b = bytes.take<uint32_t>(), c = bytes.take<uint32_t>();
    mesh.faces.push_back({a, b, c});
  }
  EXPECT_TRUE(bytes.at_end());
  return mesh;
}

ReadMesh read_stl(const std::string& path) {
  Bytes bytes(read_file(path), 80);
  const auto facets = bytes.take<uint32_t>();
  ReadMesh mesh;
  for (size_t i = 0; i < facets; ++i) {
    mesh.normals.push_back(bytes.take_place());
    for (int corner = 0; corner < 3; ++corner) mesh.places.push_back(bytes.take_place());
    mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    EXPECT_EQ(bytes.take<uint16_t>(), 0);
  }
  EXPECT_TRUE(bytes.at_end());
  return mesh;
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
    EXPECT_EQ(json["asset"]["version"], "2.0");
    EXPECT_EQ(json["buffers"][0]["byteLength"], bin.size());
    EXPECT_EQ(json["nodes"][json["scenes"][json["scene"].get<size_t>()]["nodes"][0].get<size_t>()]["mesh"], 0);
    check_views();
  }

  /// The values of an accessor of this type: "SCALAR", "VEC2", "VEC3".
  template <class T>
  std::vector<T> values(const nlohmann::json& accessor, const std::string& type) const {
    const auto& a = json["accessors"][accessor.get<size_t>()];
    EXPECT_EQ(a["type"], type);
    EXPECT_EQ(a["componentType"], (std::is_same_v<T, float>) ? 5126 : 5125);
    const auto& view = json["bufferViews"][a["bufferView"].get<size_t>()];
    const size_t components = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : 3;
    std::vector<T> result(a["count"].get<size_t>() * components);
    EXPECT_EQ(view["byteLength"], result.size() * sizeof(T));
    std::memcpy(result.data(), bin.data() + view["byteOffset"].get<size_t>(), result.size() * sizeof(T));
    return result;
  }

  ReadMesh mesh(size_t primitive) const {
    const auto& p = json["meshes"][0]["primitives"][primitive];
    const auto triples = [&](const char* name) {
      const std::vector<float> numbers = values<float>(p["attributes"][name], "VEC3");
      std::vector<Vec3> all;
      for (size_t i = 0; i < numbers.size(); i += 3) all.push_back(z_up({numbers[i], numbers[i + 1], numbers[i + 2]}));
      return all;
    };
    ReadMesh mesh{triples("POSITION"), triples("NORMAL"), {}, {}};
    if (p["attributes"].contains("TEXCOORD_0")) {
      const std::vector<float> uv = values<float>(p["attributes"]["TEXCOORD_0"], "VEC2");
      for (size_t i = 0; i < uv.size(); i += 2) mesh.uvs.push_back({uv[i], uv[i + 1]});
    }
    const std::vector<uint32_t> corners = values<uint32_t>(p["indices"], "SCALAR");
    EXPECT_EQ(corners.size() % 3, 0U);
    for (size_t i = 0; i < corners.size(); i += 3) mesh.faces.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return mesh;
  }

 private:
  /// Views lie in the buffer, on multiples of four, and do not overlap.
  void check_views() const {
    size_t last = 0;
    for (const auto& view : json["bufferViews"]) {
      const size_t offset = view["byteOffset"], length = view["byteLength"];
      EXPECT_EQ(offset % 4, 0U);
      EXPECT_GE(offset, last);
      last = offset + length;
      EXPECT_LE(last, bin.size());
    }
  }
};

void expect_sound(const ReadMesh& mesh) {
  for (const Vec3& normal : mesh.normals) EXPECT_NEAR(std::sqrt(dot(normal, normal)), 1.0, 1e-5);
  for (const auto& face : mesh.faces) {
    for (const size_t corner : face) ASSERT_LT(corner, mesh.places.size());
    const Vec3 normal = face_normal(mesh, face);
    EXPECT_GT(dot(normal, normal), 0.0);
  }
}

/// The normal of the ground at a cell, by the cells beside it.
Vec3 ground_normal(const HeightField& heights, int x, int y) {
  const auto slope = [&](int dx, int dy) {
    const double rise = static_cast<double>(heights.clamped(x + dx, y + dy)) - heights.clamped(x - dx, y - dy);
    const int cells =
        static_cast<int>(heights.contains(x + dx, y + dy)) + static_cast<int>(heights.contains(x - dx, y - dy));
    return rise / (cells * heights.cell_m());
  };
  const double east = slope(1, 0), north = slope(0, -1), length = std::sqrt(east * east + north * north + 1.0);
  return {-east / length, -north / length, 1.0 / length};
}

/// Every cell's centre is there with its height, and nothing else; faces look up and cover the terrain once.
void expect_is_terrain(const ReadMesh& mesh, const HeightField& heights) {
  expect_sound(mesh);
  const double cell = heights.cell_m();
  const double half_width = 0.5 * (heights.width() - 1) * cell, half_height = 0.5 * (heights.height() - 1) * cell;
  Grid<int> seen(heights.frame(), 0);
  for (size_t i = 0; i < mesh.places.size(); ++i) {
    const Vec3& p = mesh.places[i];
    const double column = (p[0] + half_width) / cell, row = (half_height - p[1]) / cell;
    const int x = static_cast<int>(std::lround(column)), y = static_cast<int>(std::lround(row));
    ASSERT_TRUE(heights.contains(x, y));
    EXPECT_NEAR(column, x, 1e-4);
    EXPECT_NEAR(row, y, 1e-4);
    EXPECT_EQ(static_cast<float>(p[2]), heights(x, y));
    seen(x, y) = 1;
    if (mesh.normals.size() == mesh.places.size()) {
      EXPECT_NEAR(dot(mesh.normals[i], ground_normal(heights, x, y)), 1.0, 1e-5);
    }
    if (mesh.uvs.empty()) continue;
    EXPECT_NEAR(mesh.uvs[i][0], (x + 0.5) / heights.width(), 1e-6);
    EXPECT_NEAR(mesh.uvs[i][1], (y + 0.5) / heights.height(), 1e-6);
  }
  for (const int cells : seen.cells()) EXPECT_EQ(cells, 1);
  EXPECT_EQ(mesh.faces.size(), 2U * static_cast<size_t>((heights.width() - 1) * (heights.height() - 1)));
  double area = 0.0;
  for (const auto& face : mesh.faces) {
    const double up = 0.5 * face_normal(mesh, face)[2];
    EXPECT_NEAR(up, 0.5 * cell * cell, 1e-3 * cell * cell);
    area += up;
  }
  EXPECT_NEAR(area, 4.0 * half_width * half_height, 1e-6 * area);
}

/// Each edge of a face is the same edge of one other face, run the other way.
void expect_watertight(const ReadMesh& mesh) {
  std::map<std::array<Vec3, 2>, int> edges;
  double volume6 = 0.0;
  for (const auto& face : mesh.faces) {
    for (size_t k = 0; k < 3; ++k) ++edges[{mesh.places[face[k]], mesh.places[face[(k + 1) % 3]]}];
    volume6 += dot(mesh.places[face[0]], cross(mesh.places[face[1]], mesh.places[face[2]]));
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    const auto twin = edges.find({edge[1], edge[0]});
    EXPECT_TRUE(twin != edges.end() && twin->second == 1);
  }
  EXPECT_GT(volume6, 0.0) << "faces look inwards";
}

TEST(MeshFiles, ObjIsTheTerrain) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(7, 4, 10));
  const Image texture(7, 4, {1, 2, 3});
  write_mesh(heights, folder("t.obj"), {.texture = &texture}, {});
  const ReadMesh mesh = read_obj(folder("t.obj"));
  EXPECT_EQ(mesh.places.size(), 28U);
  EXPECT_EQ(mesh.uvs.size(), 28U);
  EXPECT_EQ(mesh.normals.size(), 28U);
  expect_is_terrain(mesh, heights);
  const auto text_of = [&](const std::string& name) {
    const std::vector<uint8_t> bytes = read_file(folder(name));
    return std::string(bytes.begin(), bytes.end());
  };
  EXPECT_THAT(text_of("t.obj"), HasSubstr("mtllib t.mtl\n"));
  EXPECT_THAT(text_of("t.mtl"), HasSubstr("map_Kd t.png\n"));
  EXPECT_EQ(read_image(folder("t.png")), texture);
  EXPECT_EQ(folder.files(), 3U);
}

TEST(MeshFiles, PlyIsTheTerrain) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(11, 6, 10));
  write_mesh(heights, folder("t.ply"), {}, {});
  const ReadMesh mesh = read_ply(folder("t.ply"));
  EXPECT_EQ(mesh.places.size(), 66U);
  expect_is_terrain(mesh, heights);
}

TEST(MeshFiles, StlIsTheTerrain) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(11, 6, 10));
  write_mesh(heights, folder("t.stl"), {}, {});
  const ReadMesh mesh = read_stl(folder("t.stl"));
  expect_is_terrain(mesh, heights);
  for (size_t i = 0; i < mesh.faces.size(); ++i) {
    const Vec3 normal = face_normal(mesh, mesh.faces[i]);
    EXPECT_NEAR(dot(normal, mesh.normals[i]), std::sqrt(dot(normal, normal)), 1e-4 * dot(normal, normal));
  }
}

TEST(MeshFiles, SolidsToPrintAreWatertight) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(17, 12, 10));
  const float lowest = *std::min_element(heights.cells().begin(), heights.cells().end());
  for (const int64_t triangles : {int64_t{0}, int64_t{200}}) {
    write_mesh(heights, folder("t.stl"), {.max_triangles = triangles, .base_m = 50}, {});
    const ReadMesh mesh = read_stl(folder("t.stl"));
    expect_sound(mesh);
    expect_watertight(mesh);
    for (const Vec3& p : mesh.places) {
      EXPECT_LE(std::abs(p[0]), 80.0);
      EXPECT_LE(std::abs(p[1]), 55.0);
      EXPECT_GE(p[2], static_cast<double>(lowest) - 50.001);
    }
    write_mesh(heights, folder("t.ply"), {.max_triangles = triangles, .base_m = 50}, {});
    expect_watertight(read_ply(folder("t.ply")));
  }
}

TEST(MeshFiles, GlbIsTheTerrainWithItsTextureUnderWater) {
  const TestFolder folder;
  const HeightField heights = test_terrain({31, 21, 10, 5000, 7000, "EPSG:32604"});
  Image texture(31, 21, {200, 180, 140});
  texture.pixel(3, 4)[0] = 7;
  write_mesh(heights, folder("t.glb"), {.texture = &texture}, {});
  const Glb glb(folder("t.glb"));
  const auto& primitives = glb.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2U) << "terrain and water";
  expect_is_terrain(glb.mesh(0), heights);
  const ReadMesh water = glb.mesh(1);
  expect_sound(water);
  for (const Vec3& p : water.places) {
    EXPECT_EQ(std::abs(p[0]), 150.0);
    EXPECT_EQ(std::abs(p[1]), 100.0);
    EXPECT_EQ(p[2], 0.0);
  }
  for (const auto& primitive : primitives) {  // glTF asks for the box of positions
    const auto& accessor = glb.json["accessors"][primitive["attributes"]["POSITION"].get<size_t>()];
    const std::vector<float> places = glb.values<float>(primitive["attributes"]["POSITION"], "VEC3");
    for (size_t k = 0; k < 3; ++k) {
      float low = places[k], high = places[k];
      for (size_t i = k; i < places.size(); i += 3) low = std::min(low, places[i]), high = std::max(high, places[i]);
      EXPECT_EQ(accessor["min"][k], low);
      EXPECT_EQ(accessor["max"][k], high);
    }
  }
  const auto& material = glb.json["materials"][primitives[0]["material"].get<size_t>()];
  const size_t shown = material["pbrMetallicRoughness"]["baseColorTexture"]["index"];
  const auto& image = glb.json["images"][glb.json["textures"][shown]["source"].get<size_t>()];
  const auto& view = glb.json["bufferViews"][image["bufferView"].get<size_t>()];
  EXPECT_EQ(read_image(std::span(glb.bin).subspan(view["byteOffset"], view["byteLength"]), "texture"), texture);
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["crs"], "EPSG:32604");
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["origin_x_m"], 5155.0);
  EXPECT_EQ(glb.json["materials"][primitives[1]["material"].get<size_t>()]["alphaMode"], "BLEND");
}

TEST(MeshFiles, PlainGlbHasNoTextureAndNoWater) {
  const TestFolder folder;
  const HeightField heights(GridFrame::centred(4, 4, 1), 5.0F);
  write_mesh(heights, folder("t.glb"), {}, {});
  const Glb glb(folder("t.glb"));
  EXPECT_EQ(glb.json["meshes"][0]["primitives"].size(), 1U);
  EXPECT_FALSE(glb.json.contains("images"));
  expect_is_terrain(glb.mesh(0), heights);
}

}  // namespace
}  // namespace seamount::io

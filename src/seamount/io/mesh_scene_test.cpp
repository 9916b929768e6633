#include "seamount/io/mesh_scene.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "seamount/io/mesh_file.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

/// A square of two triangles, z by place and tile.
Mesh square(float z) {
  MeshPart part;
  part.positions = {-5, 5, z, -5, -5, z + 1, 5, -5, z + 2, 5, 5, z + 3};
  part.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  part.uvs = {0, 0, 0, 1, 1, 1, 1, 0};
  part.indices = {0, 1, 2, 0, 2, 3};
  return {.parts = {part}, .origin = {}};
}

/// Numbers of an accessor, as a reader of glTF finds them: through view and buffer, from the file that it names.
template <class T>
std::vector<T> numbers(const nlohmann::json& scene, const std::string& folder, size_t accessor, size_t components) {
  const auto& a = scene["accessors"][accessor];
  const auto& view = scene["bufferViews"][a["bufferView"].get<size_t>()];
  const auto& buffer = scene["buffers"][view["buffer"].get<size_t>()];
  const std::vector<uint8_t> bytes = read_file(folder + "/" + buffer["uri"].get<std::string>());
  EXPECT_EQ(bytes.size(), buffer["byteLength"].get<size_t>());
  const auto offset = view["byteOffset"].get<size_t>();
  EXPECT_EQ(offset % 4, 0U);
  EXPECT_LE(offset + view["byteLength"].get<size_t>(), bytes.size());
  std::vector<T> values(a["count"].get<size_t>() * components);
  EXPECT_EQ(view["byteLength"].get<size_t>(), values.size() * sizeof(T));
  std::memcpy(values.data(), bytes.data() + offset, values.size() * sizeof(T));
  return values;
}

void check_scene(bool textured) {
  const TestFolder folder;
  MeshTileSet set{.frame = {3, 2, 10, 0, 0, ""}, .tile_size = 2, .columns = 2, .rows = 1, .levels = 2, .tiles = {}};
  Image picture(3, 2);
  for (int x = 0; x < 2; ++x) {
    for (int level = 0; level < 2; ++level) {
      const std::string path = folder("w_x" + std::to_string(x) + "_y0_lod" + std::to_string(level) + ".glb");
      write_mesh(square(static_cast<float>(10 * x + 100 * level)), path, {.texture = textured ? &picture : nullptr});
      set.tiles.push_back(
          {.x = x, .level = level, .path = path, .east_m = 10.0 * x - 5, .north_m = 2.5, .triangles = 2});
    }
  }
  write_mesh_scene(set, folder("w.glb"));
  const std::vector<uint8_t> text = read_file(mesh_scene(folder("w.glb")));
  const auto scene = nlohmann::json::parse(text.begin(), text.end());
  const auto& roots = scene["scenes"][0]["nodes"];
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_EQ(scene["materials"].size(), textured ? 4U : 1U);
  EXPECT_EQ(scene["extensionsUsed"][0], "MSFT_lod");
  const std::string where = std::filesystem::path(folder("w")).parent_path();
  for (size_t x = 0; x < 2; ++x) {
    const auto& fine = scene["nodes"][roots[x].get<size_t>()];
    EXPECT_EQ(fine["translation"], (std::vector<double>{10.0 * static_cast<double>(x) - 5, 0, -2.5}));
    const auto& coarse = scene["nodes"][fine["extensions"]["MSFT_lod"]["ids"][0].get<size_t>()];
    for (const auto& [node, z] : {std::pair{fine, 0.0F}, {coarse, 100.0F}}) {
      const auto& part = scene["meshes"][node["mesh"].get<size_t>()]["primitives"][0];
      const auto places = numbers<float>(scene, where, part["attributes"]["POSITION"].get<size_t>(), 3);
      EXPECT_EQ(places[1], z + 10.0F * static_cast<float>(x));
      EXPECT_EQ(places[4], z + 10.0F * static_cast<float>(x) + 1);
      EXPECT_EQ(numbers<uint32_t>(scene, where, part["indices"].get<size_t>(), 1),
                (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
      const auto& surface = scene["materials"][part["material"].get<size_t>()]["pbrMetallicRoughness"];
      EXPECT_EQ(surface.contains("baseColorTexture"), textured);
      if (!textured) continue;
      const auto& texture = scene["textures"][surface["baseColorTexture"]["index"].get<size_t>()];
      const auto& view =
          scene["bufferViews"][scene["images"][texture["source"].get<size_t>()]["bufferView"].get<size_t>()];
      EXPECT_EQ(scene["buffers"][view["buffer"].get<size_t>()]["uri"],
                "w_x" + std::to_string(x) + "_y0_lod" + (z > 0 ? "1" : "0") + ".glb");
    }
  }
}

TEST(MeshScene, ReadsEveryTileFromItsOwnFile) { check_scene(false); }
TEST(MeshScene, AndItsTexture) { check_scene(true); }

TEST(MeshScene, TheListPlacesTilesInTheFilesAxes) {
  const TestFolder folder;
  MeshTileSet set{.frame = {3, 2, 10, 100, 200, "EPSG:32604"}, .tile_size = 2, .columns = 2, .rows = 1, .tiles = {}};
  set.tiles.push_back({.path = "w_x0_y0_lod0", .east_m = -5, .north_m = 2.5, .triangles = 2});
  for (const auto& [name, position] : {std::pair{"w.glb", std::vector<double>{-5, 0, -2.5}},
                                       {"w.obj", {-5, 0, -2.5}},
                                       {"w.stl", {-5, 2.5, 0}},
                                       {"w.ply", {-5, 2.5, 0}}}) {
    write_mesh_list(set, folder(name));
    const std::vector<uint8_t> text = read_file(folder("w_tiles.json"));
    const auto list = nlohmann::json::parse(text.begin(), text.end());
    EXPECT_EQ(list["tiles"][0]["position"], position) << name;
    EXPECT_EQ(list["origin_x_m"], 115);
    EXPECT_EQ(list["crs"], "EPSG:32604");
  }
}

}  // namespace
}  // namespace seamount::io

#include "seamount/io/mesh_scene.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"

namespace seamount::io {
namespace {

using Json = nlohmann::ordered_json;

std::string stem_of(const std::string& path) { return path.substr(0, path.size() - extension_of(path).size()); }
std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// A GLB file's document, and where its buffer lies in the file.
struct Glb {
  Json json;
  size_t buffer_at = 0;
  size_t file_bytes = 0;
};

Glb read_own_glb(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<uint32_t, 5> head{};  // magic, version, length of the file; length of the document, its name
  if (!file.read(reinterpret_cast<char*>(head.data()), sizeof head))
    throw IoError(path, "has gone while it was needed");
  std::string text(head[3], ' ');
  if (!file.read(text.data(), static_cast<std::streamsize>(text.size())))
    throw IoError(path, "has gone while it was needed");
  constexpr size_t kChunkHead = 8;
  return {Json::parse(text), sizeof head + text.size() + kChunkHead, head[2]};
}

/// Puts documents together: whatever one of them numbers is counted on from those before.
class Scene {
 public:
  Json json;

  size_t count(const char* list) const { return json.contains(list) ? json[list].size() : 0; }

  /// Adds what a GLB file holds but its nodes; the number of its mesh.
  size_t add(const Glb& glb, const std::string& name) {
    const size_t buffer = count("buffers"), view = count("bufferViews"), accessor = count("accessors"),
                 mesh = count("meshes"), image = count("images"), texture = count("textures");
    json["buffers"].push_back({{"uri", name}, {"byteLength", glb.file_bytes}});
    for (Json item : glb.json["bufferViews"]) {
      item["buffer"] = buffer;
      item["byteOffset"] = item["byteOffset"].get<size_t>() + glb.buffer_at;
      json["bufferViews"].push_back(std::move(item));
    }
    for (Json item : glb.json["accessors"]) {
      raise(item["bufferView"], view);
      json["accessors"].push_back(std::move(item));
    }
    if (glb.json.contains("images")) {
      for (Json item : glb.json["images"]) raise(item["bufferView"], view), json["images"].push_back(std::move(item));
      for (Json item : glb.json["textures"]) raise(item["source"], image), json["textures"].push_back(std::move(item));
      json["samplers"] = glb.json["samplers"];  // all have the same
    }
    std::vector<size_t> materials;
    for (Json item : glb.json["materials"]) materials.push_back(add_material(std::move(item), texture));
    for (Json item : glb.json["meshes"]) {
      for (Json& part : item["primitives"]) {
        for (auto& [attribute, number] : part["attributes"].items()) raise(number, accessor);
        raise(part["indices"], accessor);
        part["material"] = materials[part["material"].get<size_t>()];
      }
      json["meshes"].push_back(std::move(item));
    }
    return mesh;
  }

  size_t add_node(Json node) {
    json["nodes"].push_back(std::move(node));
    return json["nodes"].size() - 1;
  }

 private:
  static void raise(Json& number, size_t by) { number = number.get<size_t>() + by; }

  /// Materials without a texture are alike in all tiles.
  size_t add_material(Json material, size_t texture) {
    Json& surface = material["pbrMetallicRoughness"];
    if (surface.contains("baseColorTexture")) {
      raise(surface["baseColorTexture"]["index"], texture);
    } else {
      for (size_t i = 0; i < count("materials"); ++i)
        if (json["materials"][i] == material) return i;
    }
    json["materials"].push_back(std::move(material));
    return json["materials"].size() - 1;
  }
};

Json node_of(const TileMesh& tile, size_t mesh) {
  return {{"name", fmt::format("tile_x{}_y{}_lod{}", tile.x, tile.y, tile.level)},
          {"translation", {tile.east_m, 0.0, 0.0 - tile.north_m}},
          {"mesh", mesh}};
}

}  // namespace

std::string mesh_list(const std::string& path) { return stem_of(path) + "_tiles.json"; }
std::string mesh_scene(const std::string& path) { return stem_of(path) + ".gltf"; }

void write_mesh_list(const MeshTileSet& set, const std::string& path) {
  const GridFrame& frame = set.frame;
  const std::string extension = extension_of(path);
  const bool y_up = extension == ".glb" || extension == ".obj";
  Json json = {{"seamount", "mesh_tiles"}, {"width", frame.width},      {"height", frame.height},
               {"cell_m", frame.cell_m},   {"west_m", frame.west_m},    {"north_m", frame.north_m},
               {"east_m", frame.east_m()}, {"south_m", frame.south_m()}};
  if (!frame.crs.empty()) json["crs"] = frame.crs;
  json["tile_size"] = set.tile_size;
  json["columns"] = set.columns;
  json["rows"] = set.rows;
  json["levels"] = set.levels;
  if (set.vertical_scale != 1.0) json["vertical_scale"] = set.vertical_scale;
  json["axes"] = y_up ? "metres; x east, y up, z south" : "metres; x east, y north, z up";
  json["origin_x_m"] = frame.west_m + 0.5 * frame.width_m();
  json["origin_y_m"] = frame.north_m - 0.5 * frame.height_m();
  json["tiles"] = Json::array();
  for (const TileMesh& tile : set.tiles) {
    const double y = y_up ? 0.0 : tile.north_m, z = y_up ? 0.0 - tile.north_m : 0.0;
    json["tiles"].push_back({{"file", file_name(tile.path)},
                             {"x", tile.x},
                             {"y", tile.y},
                             {"level", tile.level},
                             {"column", tile.column},
                             {"row", tile.row},
                             {"width", tile.width},
                             {"height", tile.height},
                             {"position", {tile.east_m, y, z}},
                             {"low_m", tile.low_m},
                             {"high_m", tile.high_m},
                             {"triangles", tile.triangles},
                             {"largest_error_m", tile.largest_error_m}});
  }
  if (!set.provenance.program.empty()) json["made_by"] = set.provenance.program;
  write_text(mesh_list(path), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void write_mesh_scene(const MeshTileSet& set, const std::string& path) {
  Scene scene;
  scene.json["asset"] = {{"version", "2.0"},
                         {"generator", set.provenance.program.empty() ? "Seamount" : set.provenance.program}};
  scene.json["scene"] = 0;
  Json roots = Json::array();
  size_t root = 0;
  for (const TileMesh& tile : set.tiles) {
    Json node = node_of(tile, scene.add(read_own_glb(tile.path), file_name(tile.path)));
    if (tile.level == 0) {
      root = scene.add_node(std::move(node));
      roots.push_back(root);
      continue;
    }
    const size_t level = scene.add_node(std::move(node));
    scene.json["nodes"][root]["extensions"]["MSFT_lod"]["ids"].push_back(level);
  }
  if (set.levels > 1) scene.json["extensionsUsed"] = {"MSFT_lod"};
  scene.json["scenes"] = {{{"nodes", std::move(roots)}}};
  write_text(mesh_scene(path), scene.json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace seamount::io

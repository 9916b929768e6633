// glTF 2.0 binary (Khronos specification, sec. 4): a header, a JSON chunk and a chunk of buffers.
#include <algorithm>
#include <cstring>
#include <deque>
#include <limits>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/mesh_formats.h"

namespace seamount::io {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kFloat = 5126, kUint = 5125, kVertices = 34962, kIndices = 34963;

/// glTF's y is up and its z points south.
std::vector<float> y_up(const std::vector<float>& z_up) {
  std::vector<float> turned(z_up.size());
  for (size_t i = 0; i < z_up.size(); i += 3) {
    turned[i] = z_up[i];
    turned[i + 1] = z_up[i + 2];
    turned[i + 2] = 0.0F - z_up[i + 1];
  }
  return turned;
}

/// The document and the buffer's pieces in order, each padded to 4 bytes.
class GlbBuilder {
 public:
  Json json;

  template <class T>
  int accessor(const std::vector<T>& values, int components, int target) {
    const int view = buffer_view(values.data(), values.size() * sizeof(T));
    json["bufferViews"].back()["target"] = target;
    const char* type = components == 1 ? "SCALAR" : components == 2 ? "VEC2" : "VEC3";
    json["accessors"].push_back({{"bufferView", view},
                                 {"componentType", target == kIndices ? kUint : kFloat},
                                 {"count", values.size() / static_cast<size_t>(components)},
                                 {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
  }

  int positions(const std::vector<float>& values) {
    const int index = accessor(values, 3, kVertices);
    std::array<float, 3> low{values[0], values[1], values[2]}, high = low;
    for (size_t i = 0; i < values.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], values[i]);
      high[i % 3] = std::max(high[i % 3], values[i]);
    }
    json["accessors"].back()["min"] = low;
    json["accessors"].back()["max"] = high;
    return index;
  }

  /// The bytes must stay until write().
  int buffer_view(const void* data, size_t bytes) {
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", length_}, {"byteLength", bytes}});
    pieces_.emplace_back(static_cast<const uint8_t*>(data), bytes);
    length_ += (bytes + 3) / 4 * 4;
    return static_cast<int>(pieces_.size()) - 1;
  }

  void write(const std::string& path) {
    json["buffers"] = {{{"byteLength", length_}}};
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    const uint64_t total = 12 + 8 + text.size() + 8 + length_;
    if (total > std::numeric_limits<uint32_t>::max())
      throw IoError(path, "the mesh is too large for a GLB file (4 GiB); set max_triangles");
    write_atomically(path, [&](const std::string& temporary) {
      FileWriter file(temporary, path);
      const auto word = [](uint64_t value) { return static_cast<uint32_t>(value); };
      constexpr uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;
      file.write_raw<uint32_t>(std::array{kMagic, 2U, word(total), word(text.size()), kJson});
      file.write_raw<char>(text);
      file.write_raw<uint32_t>(std::array{word(length_), kBin});
      constexpr std::array<uint8_t, 3> kPadding{};
      for (const auto& piece : pieces_) {
        file.write(piece);
        file.write(std::span(kPadding).first((4 - piece.size() % 4) % 4));
      }
      file.close();
    });
  }

 private:
  std::vector<std::span<const uint8_t>> pieces_;
  size_t length_ = 0;
};

Json ground_material(bool textured) {
  Json material{{"name", "terrain"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.95}}}};
  Json& surface = material["pbrMetallicRoughness"];
  if (textured) surface["baseColorTexture"] = {{"index", 0}};
  if (!textured) surface["baseColorFactor"] = {0.55, 0.52, 0.45, 1.0};
  return material;
}

Json water_material() {
  return {{"name", "water"},
          {"alphaMode", "BLEND"},
          {"doubleSided", true},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {0.03, 0.18, 0.25, 0.6}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.1}}}};
}

Json extras(const Mesh& mesh, const Provenance& provenance) {
  Json json{{"units", "metres, sea level at y = 0"}, {"origin_x_m", mesh.origin.x}, {"origin_y_m", mesh.origin.y}};
  if (!mesh.crs.empty()) json["crs"] = mesh.crs;
  json["largest_error_m"] = mesh.largest_error_m;
  json["rms_error_m"] = mesh.rms_error_m;
  if (mesh.vertical_scale != 1.0) json["vertical_scale"] = mesh.vertical_scale;
  if (!provenance.recipe.empty()) json["recipe"] = provenance.recipe;
  if (provenance.seed) json["seed"] = *provenance.seed;
  return json;
}

}  // namespace

void write_glb(const Mesh& mesh, const std::string& path, const MeshFileOptions& options) {
  GlbBuilder glb;
  const std::string& program = options.provenance.program;
  glb.json["asset"] = {{"version", "2.0"}, {"generator", program.empty() ? "Seamount" : program}};
  glb.json["scene"] = 0;
  glb.json["scenes"] = {{{"nodes", {0}}}};
  glb.json["nodes"] = {{{"name", "terrain"}, {"mesh", 0}, {"extras", extras(mesh, options.provenance)}}};
  if (!(mesh.offset == Vec2{})) glb.json["nodes"][0]["translation"] = {mesh.offset.x, 0.0, 0.0 - mesh.offset.y};
  std::deque<std::vector<float>> turned;  // must stay until they are written
  const auto y_up_of = [&](const std::vector<float>& z_up) -> const std::vector<float>& {
    return turned.emplace_back(y_up(z_up));
  };
  Json primitives = Json::array();
  for (const MeshPart& part : mesh.parts) {
    Json attributes{{"POSITION", glb.positions(y_up_of(part.positions))},
                    {"NORMAL", glb.accessor(y_up_of(part.normals), 3, kVertices)}};
    if (!part.uvs.empty()) attributes["TEXCOORD_0"] = glb.accessor(part.uvs, 2, kVertices);
    primitives.push_back({{"attributes", std::move(attributes)},
                          {"indices", glb.accessor(part.indices, 1, kIndices)},
                          {"material", primitives.size()}});
    const bool textured = options.texture != nullptr && !part.uvs.empty();
    glb.json["materials"].push_back(part.material == MeshMaterial::water ? water_material()
                                                                         : ground_material(textured));
  }
  std::vector<uint8_t> png;
  if (options.texture != nullptr) {
    png = encode_png(*options.texture);
    glb.json["images"] = {{{"mimeType", "image/png"}, {"bufferView", glb.buffer_view(png.data(), png.size())}}};
    glb.json["samplers"] = {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}}};
    glb.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  }
  glb.json["meshes"] = {{{"name", "terrain"}, {"primitives", primitives}}};
  glb.write(path);
}

}  // namespace seamount::io

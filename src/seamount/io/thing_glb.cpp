// glTF 2.0 binary, as much of it as a model needs: triangles of the scene's nodes with positions, normals, colours.
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/printable.h"
#include "seamount/io/glb_node.h"
#include "seamount/io/glb_number.h"
#include "seamount/io/thing_parts.h"

namespace seamount::io {
namespace {

using Json = nlohmann::json;

/// The two chunks of a file.
struct Chunks {
  Json json;
  std::span<const uint8_t> bin;
};

Chunks chunks_of(std::span<const uint8_t> bytes, const std::string& name) {
  constexpr uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;
  std::array<uint32_t, 5> header{};
  if (bytes.size() < sizeof(header)) throw IoError(name, "is no GLB file, or it is cut off");
  std::memcpy(header.data(), bytes.data(), sizeof(header));
  if (header[0] != kMagic || header[1] != 2 || header[4] != kJson) throw IoError(name, "is no GLB file of version 2");
  const size_t text = header[3], rest = bytes.size() - sizeof(header);
  if (header[2] != bytes.size() || text > rest) throw IoError(name, "is cut off");
  Chunks chunks;
  chunks.json =
      Json::parse(bytes.begin() + sizeof(header), bytes.begin() + static_cast<ptrdiff_t>(sizeof(header) + text));
  const auto after = bytes.subspan(sizeof(header) + text);
  std::array<uint32_t, 2> second{};
  if (after.size() < sizeof(second)) return chunks;
  std::memcpy(second.data(), after.data(), sizeof(second));
  if (second[1] != kBin || second[0] > after.size() - sizeof(second)) throw IoError(name, "is cut off");
  chunks.bin = after.subspan(sizeof(second), second[0]);
  return chunks;
}

/// Numbers of an accessor.
class Numbers {
 public:
  Numbers(const Chunks& glb, size_t index) {
    const Json& accessor = glb.json.at("accessors").at(index);
    if (accessor.contains("sparse") || !accessor.contains("bufferView"))
      throw std::invalid_argument("has sparse data, which is not read");
    const Json& view = glb.json.at("bufferViews").at(natural(accessor.at("bufferView")));
    if (natural(view, "buffer", 0) != 0) throw std::invalid_argument("keeps data in other files");
    type_ = natural(accessor.at("componentType"));
    normalized_ = accessor.value("normalized", false);
    const auto type = accessor.at("type").get<std::string>();
    parts = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
    size_ = type_ == 5120 || type_ == 5121   ? 1
            : type_ == 5122 || type_ == 5123 ? 2
            : type_ == 5125 || type_ == 5126 ? 4
                                             : 0;
    if (parts == 0 || size_ == 0) throw std::invalid_argument("has data of an unknown type");
    count = natural(accessor.at("count"));
    stride_ = natural(view, "byteStride", parts * size_);
    const auto view_at = natural(view, "byteOffset", 0), length = natural(view.at("byteLength")),
               at = natural(accessor, "byteOffset", 0);
    constexpr size_t kMost = size_t{1} << 28;
    if (count > kMost || stride_ > 4096 || length > glb.bin.size() || view_at > glb.bin.size() - length ||
        at > length || (count > 0 && (stride_ * (count - 1) + parts * size_ > length - at)))
      throw std::invalid_argument("has data beyond its end");
    data_ = glb.bin.data() + view_at + at;
  }

  double operator()(size_t i, size_t part) const {
    const uint8_t* from = data_ + i * stride_ + part * size_;
    switch (type_) {
      case 5120:
        return scaled(read<int8_t>(from), 127.0);
      case 5121:
        return scaled(read<uint8_t>(from), 255.0);
      case 5122:
        return scaled(read<int16_t>(from), 32767.0);
      case 5123:
        return scaled(read<uint16_t>(from), 65535.0);
      case 5125:
        return read<uint32_t>(from);
      default:
        return read<float>(from);
    }
  }

  size_t count = 0, parts = 0;

 private:
  template <class T>
  static T read(const uint8_t* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
  }
  double scaled(double value, double most) const { return normalized_ ? std::max(value / most, -1.0) : value; }

  const uint8_t* data_ = nullptr;
  size_t type_ = 0, size_ = 0, stride_ = 0;
  bool normalized_ = false;
};

struct Surface {
  std::array<float, 3> colour = {0.8F, 0.8F, 0.8F};
  bool two_sided = false, textured = false;
};

class Reader {
 public:
  Reader(const Chunks& glb, const std::string& name, const RunContext& run) : glb_(glb), parts_(name), run_(run) {}

  ThingMesh mesh(const std::string& name) {
    for (const Json& extension : glb_.json.value("extensionsRequired", Json::array()))
      if (extension != "KHR_materials_unlit" && extension != "KHR_mesh_quantization")
        throw std::invalid_argument("needs " + printable(extension.get<std::string>()) + ", which is not read");
    const Json& scene = glb_.json.at("scenes").at(natural(glb_.json, "scene", 0));
    for (const Json& node : scene.value("nodes", Json::array())) visit(natural(node), kIdentityMatrix, 0);
    if (textured_) run_.say(name + ": its textures are not read, only colours");
    return parts_.mesh();
  }

 private:
  void visit(size_t index, const Matrix4& outer, int depth) {
    constexpr int kDeepest = 64, kMostNodes = 1 << 16;  // a damaged file may have nodes in circles
    if (depth > kDeepest || ++visited_ > kMostNodes) throw std::invalid_argument("its nodes have no end");
    run_.check_cancelled();
    const Json& node = glb_.json.at("nodes").at(index);
    const Matrix4 matrix = product(outer, matrix_of(node));
    if (node.contains("mesh")) {
      for (const Json& primitive : glb_.json.at("meshes").at(natural(node.at("mesh"))).at("primitives"))
        if (natural(primitive, "mode", 4) == 4) add(primitive, matrix);
    }
    for (const Json& child : node.value("children", Json::array())) visit(natural(child), matrix, depth + 1);
  }

  Surface surface_of(const Json& primitive) {
    Surface made;
    if (!primitive.contains("material")) return made;
    const Json& material = glb_.json.at("materials").at(natural(primitive.at("material")));
    made.two_sided = material.value("doubleSided", false);
    const Json pbr = material.value("pbrMetallicRoughness", Json::object());
    const auto factor = pbr.value("baseColorFactor", std::array<double, 4>{1, 1, 1, 1});
    for (size_t k = 0; k < 3; ++k) made.colour[k] = static_cast<float>(factor[k]);
    made.textured = pbr.contains("baseColorTexture");
    textured_ = textured_ || made.textured;
    return made;
  }

  void add(const Json& primitive, const Matrix4& m) {
    if (primitive.contains("extensions") && primitive.at("extensions").contains("KHR_draco_mesh_compression"))
      throw std::invalid_argument("is compressed (Draco), which is not read");
    const Json& attributes = primitive.at("attributes");
    const Numbers places(glb_, natural(attributes.at("POSITION")));
    std::optional<Numbers> normals, colours, indices;
    if (attributes.contains("NORMAL")) normals.emplace(glb_, natural(attributes.at("NORMAL")));
    if (attributes.contains("COLOR_0")) colours.emplace(glb_, natural(attributes.at("COLOR_0")));
    if (primitive.contains("indices")) indices.emplace(glb_, natural(primitive.at("indices")));
    for (const auto* numbers : {&normals, &colours})
      if (*numbers && ((*numbers)->count < places.count || (*numbers)->parts < 3))
        throw std::invalid_argument("has vertices without a normal or colour");
    if (places.parts != 3) throw std::invalid_argument("has positions without three coordinates");
    const Surface surface = surface_of(primitive);
    const auto corner = [&](size_t i) {
      ThingCorner made;
      for (size_t k = 0; k < 3; ++k) {
        double p = m[12 + k], n = 0.0;
        for (size_t axis = 0; axis < 3; ++axis) {
          p += m[4 * axis + k] * places(i, axis);
          if (normals) n += m[4 * axis + k] * (*normals)(i, axis);
        }
        made.place[k] = static_cast<float>(p);
        made.normal[k] = static_cast<float>(n);
        made.colour[k] = surface.colour[k] * (colours ? static_cast<float>((*colours)(i, k)) : 1.0F);
      }
      return made;
    };
    const size_t corners = indices ? indices->count : places.count;
    for (size_t i = 0; i + 2 < corners; i += 3) {
      std::array<ThingCorner, 3> triangle;
      for (size_t k = 0; k < 3; ++k) {
        const double at = indices ? (*indices)(i + k, 0) : static_cast<double>(i + k);
        if (!(at >= 0.0 && at < static_cast<double>(places.count)))
          throw std::invalid_argument("has an index that leads nowhere");
        triangle[k] = corner(static_cast<size_t>(at));
      }
      parts_.triangle(triangle, surface.two_sided);
    }
  }

  const Chunks& glb_;
  ThingParts parts_;
  const RunContext& run_;
  int visited_ = 0;
  bool textured_ = false;
};

}  // namespace

ThingMesh glb_thing(std::span<const uint8_t> bytes, const std::string& name, const RunContext& run) {
  try {
    const Chunks chunks = chunks_of(bytes, name);
    return Reader(chunks, name, run).mesh(name);
  } catch (const Json::exception&) {
    throw IoError(name, "has a damaged description");
  } catch (const std::invalid_argument& error) {
    throw IoError(name, error.what());
  }
}

}  // namespace seamount::io

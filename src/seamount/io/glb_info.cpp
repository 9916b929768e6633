#include "seamount/io/glb_info.h"

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/glb_node.h"
#include "seamount/io/glb_number.h"

namespace seamount::io {
namespace {

using Json = nlohmann::json;
Json description_of(std::span<const uint8_t> bytes, const std::string& name) {
  constexpr uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A;
  std::array<uint32_t, 5> header{};
  if (bytes.size() < sizeof(header)) throw IoError(name, "is no GLB file, or it is cut off");
  std::memcpy(header.data(), bytes.data(), sizeof(header));
  if (header[0] != kMagic || header[1] != 2 || header[4] != kJson) throw IoError(name, "is no GLB file of version 2");
  if (header[2] != bytes.size() || header[3] > bytes.size() - sizeof(header)) throw IoError(name, "is cut off");
  return Json::parse(bytes.begin() + sizeof(header), bytes.begin() + sizeof(header) + header[3]);
}

class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) { mesh_.format = "GLB"; }

  MeshSummary summary() {
    const Json& scene = json_.at("scenes").at(natural(json_, "scene", 0));
    for (const Json& node : scene.value("nodes", Json::array())) visit(natural(node), kIdentityMatrix, 0);
    if (scene.contains("extras")) tell_things(scene.at("extras"));
    if (const Json asset = json_.value("asset", Json::object()); asset.contains("generator"))
      mesh_.said.emplace_back("made by", asset.at("generator").get<std::string>());
    return mesh_;
  }

 private:
  void visit(size_t index, const Matrix4& outer, int depth) {
    constexpr int kDeepest = 64;  // nodes are a tree; a damaged file may have them in circles
    constexpr int kMostNodes = 1 << 20;
    if (depth > kDeepest || ++visited_ > kMostNodes) throw std::invalid_argument("its nodes have no end");
    const Json& node = json_.at("nodes").at(index);
    const Matrix4 matrix = product(outer, matrix_of(node));
    if (node.contains("mesh")) {
      const Json& primitives = json_.at("meshes").at(natural(node.at("mesh"))).at("primitives");
      if (const Json* instancing = instancing_of(node)) {
        add_instances(primitives, instancing->at("attributes"), matrix);
      } else {
        for (const Json& primitive : primitives) add(primitive, matrix);
      }
    }
    if (node.contains("extras") && mesh_.said.empty()) tell(node.at("extras"));
    for (const Json& child : node.value("children", Json::array())) visit(natural(child), matrix, depth + 1);
  }

  static const Json* instancing_of(const Json& node) {
    if (!node.contains("extensions")) return nullptr;
    const auto found = node.at("extensions").find("EXT_mesh_gpu_instancing");
    return found == node.at("extensions").end() ? nullptr : &*found;
  }

  /// Each instance counts; where they lie is known from the least and largest translation and scale, if the file says.
  void add_instances(const Json& primitives, const Json& attributes, const Matrix4& matrix) {
    const Json none;
    const auto accessor = [&](const char* name) -> const Json& {
      return attributes.contains(name) ? json_.at("accessors").at(natural(attributes.at(name))) : none;
    };
    if (attributes.empty()) throw std::invalid_argument("has instances without places");
    const Json &places = accessor("TRANSLATION"), &scales = accessor("SCALE");
    const Json& any = places.is_null() ? json_.at("accessors").at(natural(*attributes.begin())) : places;
    const auto count = natural(any.at("count"));
    constexpr size_t kMost = size_t{1} << 32;
    if (count > kMost) throw std::invalid_argument("has more instances than there can be");
    mesh_.instances += count;
    const size_t triangles = mesh_.triangles, vertices = mesh_.vertices;
    const std::array<double, 3> zero{}, one{1, 1, 1};
    const auto low = places.is_object() ? places.value("min", zero) : zero,
               high = places.is_object() ? places.value("max", zero) : zero,
               largest = scales.is_object() ? scales.value("max", one) : one;
    for (const auto& end : {low, high}) {
      mesh_.triangles = triangles;
      mesh_.vertices = vertices;
      for (const Json& primitive : primitives) add(primitive, product(matrix, matrix_of(end, {0, 0, 0, 1}, largest)));
    }
    mesh_.parts -= primitives.size();  // both ends were counted
    mesh_.triangles = triangles + (mesh_.triangles - triangles) * count;
  }

  void add(const Json& primitive, const Matrix4& matrix) {
    const Json& places = json_.at("accessors").at(natural(primitive.at("attributes").at("POSITION")));
    const auto vertices = natural(places.at("count"));
    size_t corners = vertices;
    if (primitive.contains("indices"))
      corners = natural(json_.at("accessors").at(natural(primitive.at("indices"))).at("count"));
    const size_t mode = natural(primitive, "mode", 4);
    if (mode == 4) mesh_.triangles += corners / 3;
    if ((mode == 5 || mode == 6) && corners > 2) mesh_.triangles += corners - 2;
    mesh_.vertices += vertices;
    ++mesh_.parts;
    const auto low = places.at("min").get<std::array<double, 3>>(),
               high = places.at("max").get<std::array<double, 3>>();
    for (size_t corner = 0; corner < 8; ++corner) {
      std::array<double, 3> p{};
      for (size_t k = 0; k < 3; ++k) {
        p[k] = matrix[12 + k];
        for (size_t axis = 0; axis < 3; ++axis)
          p[k] += matrix[4 * axis + k] * ((corner >> axis & 1U) != 0 ? high[axis] : low[axis]);
      }
      mesh_.add_box({p[0], -p[2], p[1]}, {p[0], -p[2], p[1]});
    }
  }

  /// What write_things_glb() says of them.
  void tell_things(const Json& extras) {
    for (const char* key : {"things", "shapes"})
      if (extras.is_object() && extras.contains(key) && extras.at(key).is_number())
        mesh_.said.emplace_back(key, format_number(extras.at(key).get<double>()));
  }

  /// What write_glb() says of a terrain.
  void tell(const Json& extras) {
    const auto number = [&](const char* key) -> std::optional<double> {
      if (!extras.is_object() || !extras.contains(key) || !extras.at(key).is_number()) return std::nullopt;
      return extras.at(key).get<double>();
    };
    if (const auto largest = number("largest_error_m"), rms = number("rms_error_m"); largest && rms)
      mesh_.said.emplace_back("from the terrain",
                              "at most " + short_number(*largest) + " m, " + short_number(*rms) + " m rms");
    if (const auto x = number("origin_x_m"), y = number("origin_y_m"); x && y)
      mesh_.said.emplace_back("middle of the terrain", format_number(*x) + " m, " + format_number(*y) + " m");
    if (const auto scale = number("vertical_scale")) mesh_.said.emplace_back("vertical scale", short_number(*scale));
  }

  const Json& json_;
  MeshSummary mesh_;
  int visited_ = 0;
};

}  // namespace

MeshSummary glb_summary(std::span<const uint8_t> bytes, const std::string& name) {
  try {
    const Json description = description_of(bytes, name);
    return Reader(description).summary();
  } catch (const Json::exception&) {
    throw IoError(name, "has a damaged description");
  } catch (const std::invalid_argument& error) {
    throw IoError(name, error.what());
  }
}

}  // namespace seamount::io

#include "seamount/io/glb_builder.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"

namespace seamount::io {
namespace {

constexpr int kShort = 5123, kUint = 5125, kFloat = 5126;

template <class T>
std::vector<uint8_t> raw(const std::vector<T>& values) {
  std::vector<uint8_t> made(values.size() * sizeof(T));
  if (!made.empty()) std::memcpy(made.data(), values.data(), made.size());
  return made;
}

}  // namespace

std::vector<float> y_up(const std::vector<float>& z_up) {
  std::vector<float> turned(z_up.size());
  for (size_t i = 0; i < z_up.size(); i += 3) {
    turned[i] = z_up[i];
    turned[i + 1] = z_up[i + 2];
    turned[i + 2] = 0.0F - z_up[i + 1];
  }
  return turned;
}

int GlbBuilder::view(std::vector<uint8_t> piece, int use) {
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", length_}, {"byteLength", piece.size()}});
  if (use != 0) json["bufferViews"].back()["target"] = use;
  length_ += (piece.size() + 3) / 4 * 4;
  pieces_.push_back(std::move(piece));
  return static_cast<int>(pieces_.size()) - 1;
}

int GlbBuilder::accessor(int view, int component_type, size_t count, int components) {
  constexpr std::array<const char*, 5> kTypes = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  json["accessors"].push_back({{"bufferView", view},
                               {"componentType", component_type},
                               {"count", count},
                               {"type", kTypes[static_cast<size_t>(components)]}});
  return static_cast<int>(json["accessors"].size()) - 1;
}

int GlbBuilder::floats(std::vector<float> values, int components, int use) {
  return accessor(view(raw(values), use), kFloat, values.size() / static_cast<size_t>(components), components);
}

int GlbBuilder::indices(std::vector<uint32_t> values) {
  return accessor(view(raw(values), kIndices), kUint, values.size(), 1);
}

int GlbBuilder::colours(std::vector<uint16_t> values) {
  const int index = accessor(view(raw(values), kVertices), kShort, values.size() / 4, 4);
  json["accessors"].back()["normalized"] = true;
  return index;
}

int GlbBuilder::places(std::vector<float> values, int use) {
  std::array<float, 3> low{values[0], values[1], values[2]}, high = low;
  for (size_t i = 0; i < values.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], values[i]);
    high[i % 3] = std::max(high[i % 3], values[i]);
  }
  const int index = floats(std::move(values), 3, use);
  json["accessors"].back()["min"] = low;
  json["accessors"].back()["max"] = high;
  return index;
}

int GlbBuilder::bytes(std::vector<uint8_t> values) { return view(std::move(values), 0); }

size_t GlbBuilder::add_node(OrderedJson node) {
  json["nodes"].push_back(std::move(node));
  const size_t index = json["nodes"].size() - 1;
  json["scenes"][0]["nodes"].push_back(index);
  return index;
}

int GlbBuilder::add_mesh(OrderedJson mesh) {
  json["meshes"].push_back(std::move(mesh));
  return static_cast<int>(json["meshes"].size()) - 1;
}

int GlbBuilder::add_material(OrderedJson material) {
  json["materials"].push_back(std::move(material));
  return static_cast<int>(json["materials"].size()) - 1;
}

void GlbBuilder::write(const std::string& path, const std::string& advice) {
  json["buffers"] = {{{"byteLength", length_}}};
  std::string text = json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  text.append((4 - text.size() % 4) % 4, ' ');
  const uint64_t total = 12 + 8 + text.size() + 8 + length_;
  if (total > std::numeric_limits<uint32_t>::max()) throw IoError(path, advice);
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

}  // namespace seamount::io

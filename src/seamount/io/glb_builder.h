// Puts a glTF 2.0 binary together: a document and a buffer's pieces. Not part of the public interface.
#pragma once

#include <cstdint>
#include <deque>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "seamount/io/mesh_file.h"

namespace seamount::io {

using OrderedJson = nlohmann::ordered_json;

/// glTF's y is up and its z points south.
std::vector<float> y_up(const std::vector<float>& z_up);

/// The document and the buffer's pieces in order, each padded to 4 bytes.
class GlbBuilder {
 public:
  OrderedJson json;

  static constexpr int kVertices = 34962, kIndices = 34963, kInstances = 0;

  /// Numbers of 1 to 4 components; `use` is what they are for. Copied.
  int floats(std::vector<float> values, int components, int use);
  int indices(std::vector<uint32_t> values);
  /// Colours in linear light, 16 bits, four a vertex.
  int colours(std::vector<uint16_t> values);
  /// Floats of three components with their least and largest.
  int places(std::vector<float> values, int use);
  int bytes(std::vector<uint8_t> values);

  /// A node, as the last of the scene; its number.
  size_t add_node(OrderedJson node);
  int add_mesh(OrderedJson mesh);
  int add_material(OrderedJson material);

  /// Throws IoError{path} for more than 4 GiB, with `advice`.
  void write(const std::string& path, const std::string& advice);

 private:
  int view(std::vector<uint8_t> piece, int use);
  int accessor(int view, int component_type, size_t count, int components);

  std::deque<std::vector<uint8_t>> pieces_;
  size_t length_ = 0;
};

/// Starts a document.
void begin_glb(GlbBuilder& glb, const Provenance& provenance);
/// A terrain's mesh as a node "terrain", with what is known of it in its extras.
void add_terrain(GlbBuilder& glb, const Mesh& mesh, const MeshFileOptions& options);

}  // namespace seamount::io

#include "seamount/io/mesh_info.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/glb_info.h"
#include "seamount/io/tin_file.h"

namespace seamount::io {
namespace {

std::string_view text_of(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The next word of a line, which is taken off it; empty at its end.
std::string_view next_word(std::string_view& line) {
  const size_t first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return line = {};
  const size_t last = std::min(line.find_first_of(" \t\r", first), line.size());
  const std::string_view word = line.substr(first, last - first);
  line.remove_prefix(last);
  return word;
}

std::array<double, 3> three_numbers(std::string_view line, const std::string& name) {
  std::array<double, 3> numbers{};
  for (double& number : numbers) {
    const std::string_view word = next_word(line);
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (problem != std::errc() || end != word.data() + word.size() || !std::isfinite(number))
      throw IoError(name, "has a vertex without three numbers");
  }
  return numbers;
}

template <class Visit>
void for_each_line(std::string_view text, Visit&& visit) {
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    visit(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

MeshSummary obj_summary(std::string_view text, const std::string& name) {
  MeshSummary mesh{.format = "OBJ"};
  for_each_line(text, [&](std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword == "o") ++mesh.parts;
    if (keyword == "v") {
      const auto [x, y, z] = three_numbers(line, name);
      mesh.add_vertex({x, -z, y});
    }
    if (keyword != "f") return;
    size_t corners = 0;
    while (!next_word(line).empty()) ++corners;
    if (corners < 3) throw IoError(name, "has a face of fewer than three corners");
    mesh.triangles += corners - 2;
  });
  mesh.parts = std::max<size_t>(1, mesh.parts);
  return mesh;
}

MeshSummary stl_summary(std::span<const uint8_t> bytes, const std::string& name) {
  MeshSummary mesh{.format = "STL", .parts = 1};
  std::set<std::array<double, 3>> places;
  constexpr size_t kHeader = 84, kFacet = 50;
  uint32_t count = 0;
  if (bytes.size() >= kHeader) std::memcpy(&count, bytes.data() + 80, 4);
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * size_t{count}) {
    mesh.triangles = count;
    for (size_t i = 0; i < 3 * size_t{count}; ++i) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), bytes.data() + kHeader + kFacet * (i / 3) + 12 + 12 * (i % 3), 12);
      if (!std::isfinite(p[0] + p[1] + p[2])) throw IoError(name, "has a corner that is not finite");
      places.insert({p[0], p[1], p[2]});
    }
  } else {
    if (!text_of(bytes).starts_with("solid")) throw IoError(name, "is no STL file, or it is cut off");
    size_t corners = 0;
    for_each_line(text_of(bytes), [&](std::string_view line) {
      if (next_word(line) != "vertex") return;
      places.insert(three_numbers(line, name));
      ++corners;
    });
    if (corners % 3 != 0) throw IoError(name, "has a facet that is cut off");
    mesh.triangles = corners / 3;
  }
  for (const auto& place : places) mesh.add_vertex(place);
  return mesh;
}

std::optional<MeshSummary> ply_summary(std::span<const uint8_t> bytes, const std::string& name) {
  const Tin tin = read_tin(bytes, name);
  if (tin.frame.cells() > 0 || !tin.rank.empty() || !tin.region.empty()) return std::nullopt;
  MeshSummary mesh{.format = "PLY", .triangles = tin.triangles.size(), .parts = 1};
  for (size_t i = 0; i < tin.nodes.size(); ++i)
    mesh.add_vertex({tin.nodes[i].x, tin.nodes[i].y, tin.height_m.empty() ? 0.0 : double{tin.height_m[i]}});
  return mesh;
}

FileInfo told(const MeshSummary& mesh) {
  FileInfo info{{"format", "mesh, " + mesh.format},
                {"triangles", std::to_string(mesh.triangles)},
                {"vertices", std::to_string(mesh.vertices)},
                {"parts", std::to_string(mesh.parts)}};
  if (mesh.vertices > 0) {
    const auto metres = [](double value) { return short_number(value) + " m"; };
    info.emplace_back("extent", metres(mesh.high[0] - mesh.low[0]) + " x " + metres(mesh.high[1] - mesh.low[1]));
    info.emplace_back("heights", metres(mesh.low[2]) + " to " + metres(mesh.high[2]));
  }
  info.insert(info.end(), mesh.said.begin(), mesh.said.end());
  return info;
}

}  // namespace

void MeshSummary::add_vertex(const std::array<double, 3>& place) {
  add_box(place, place);
  ++vertices;
}

void MeshSummary::add_box(const std::array<double, 3>& box_low, const std::array<double, 3>& box_high) {
  for (size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], box_low[k]);
    high[k] = std::max(high[k], box_high[k]);
  }
}

std::optional<FileInfo> describe_mesh(std::span<const uint8_t> bytes, const std::string& name) {
  const std::string extension = extension_of(name);
  if (extension == ".glb") return told(glb_summary(bytes, name));
  if (extension == ".obj") return told(obj_summary(text_of(bytes), name));
  if (extension == ".stl") return told(stl_summary(bytes, name));
  if (extension != ".ply") return std::nullopt;
  const std::optional<MeshSummary> mesh = ply_summary(bytes, name);
  return mesh ? std::optional(told(*mesh)) : std::nullopt;
}

std::optional<FileInfo> describe_mesh(const std::string& path) {
  const std::string extension = extension_of(path);
  for (const char* known : {".glb", ".obj", ".ply", ".stl"}) {
    if (extension == known) return describe_mesh(read_file(path), path);
  }
  return std::nullopt;
}

}  // namespace seamount::io

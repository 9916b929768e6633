// OBJ, PLY and STL; GLB is mesh_glb.cpp.
#include "seamount/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/mesh_formats.h"

namespace seamount::io {
namespace {

/// Text that is written out whenever a piece is full.
class TextWriter {
 public:
  explicit TextWriter(FileWriter& file) : file_(file) {}
  TextWriter& operator<<(std::string_view text) {
    text_ += text;
    constexpr size_t kPiece = 1 << 20;
    if (text_.size() > kPiece) flush();
    return *this;
  }
  template <class T>
  requires std::is_arithmetic_v<T> TextWriter& operator<<(T number) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), number).ptr;
    return *this << std::string_view(buffer, static_cast<size_t>(end - buffer));
  }
  void flush() {
    file_.write_raw<char>(text_);
    text_.clear();
  }

 private:
  FileWriter& file_;
  std::string text_;
};

/// A normal for each place: that of its first vertex, which is the ground's where walls begin.
std::vector<float> normals_of(const MeshPart& mesh, const WeldedPlaces& places) {
  std::vector<float> normals(places.positions.size());
  for (size_t v = mesh.vertex_count(); v-- > 0;)
    std::copy_n(&mesh.normals[3 * v], 3, &normals[3 * size_t{places.place[v]}]);
  return normals;
}

}  // namespace

WeldedPlaces welded(const MeshPart& part, Vec2 offset) {
  using Place = std::array<float, 3>;
  std::vector<Place> places(part.vertex_count());
  for (size_t v = 0; v < places.size(); ++v) {
    const float* p = &part.positions[3 * v];
    places[v] = {p[0] + static_cast<float>(offset.x), p[1] + static_cast<float>(offset.y), p[2]};
  }
  WeldedPlaces result;
  result.place.resize(places.size());
  std::iota(result.place.begin(), result.place.end(), 0U);
  if (part.hard_edges) {
    std::vector<uint32_t> order = result.place;
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return std::pair(places[a], a) < std::pair(places[b], b); });
    for (size_t i = 1; i < order.size(); ++i) {
      if (places[order[i]] == places[order[i - 1]]) result.place[order[i]] = result.place[order[i - 1]];
    }
  }
  for (size_t v = 0; v < places.size(); ++v) {
    const bool is_first = result.place[v] == v;
    result.place[v] = is_first ? static_cast<uint32_t>(result.positions.size() / 3) : result.place[result.place[v]];
    if (is_first) result.positions.insert(result.positions.end(), places[v].begin(), places[v].end());
  }
  return result;
}

void write_obj(const Mesh& all, const std::string& path, const MeshFileOptions& options) {
  const MeshPart& mesh = all.parts[0];
  const WeldedPlaces places = welded(mesh, all.offset);
  const std::filesystem::path stem = std::filesystem::path(path).replace_extension();
  const std::string name = stem.filename().string();
  if (options.texture != nullptr) write_png(*options.texture, stem.string() + ".png");
  write_text(stem.string() + ".mtl", "newmtl terrain\nKd 0.8 0.8 0.8\nKs 0 0 0\n" +
                                         (options.texture != nullptr ? "map_Kd " + name + ".png\n" : ""));
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    TextWriter text(file);
    text << "# metres, y up, sea level at y = 0\nmtllib " << name << ".mtl\no terrain\nusemtl terrain\n";
    for (size_t i = 0; i < places.positions.size(); i += 3)
      text << "v " << places.positions[i] << " " << places.positions[i + 2] << " " << 0.0F - places.positions[i + 1]
           << "\n";
    for (size_t i = 0; i < mesh.uvs.size(); i += 2)
      text << "vt " << mesh.uvs[i] << " " << 1.0F - mesh.uvs[i + 1] << "\n";
    for (size_t i = 0; i < mesh.normals.size(); i += 3)
      text << "vn " << mesh.normals[i] << " " << mesh.normals[i + 2] << " " << 0.0F - mesh.normals[i + 1] << "\n";
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
      const uint32_t v = mesh.indices[i];
      text << (i % 3 == 0 ? "f " : " ") << places.place[v] + 1 << "/" << v + 1 << "/" << v + 1
           << (i % 3 == 2 ? "\n" : "");
    }
    text.flush();
    file.close();
  });
}

void write_ply(const Mesh& all, const std::string& path) {
  const MeshPart& mesh = all.parts[0];
  const WeldedPlaces places = welded(mesh, all.offset);
  const std::vector<float> normals = normals_of(mesh, places);
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    const std::string header =
        "ply\nformat binary_little_endian 1.0\ncomment metres, z up, sea level at z = 0\nelement vertex " +
        std::to_string(places.positions.size() / 3) +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
        "property float ny\nproperty float nz\nelement face " +
        std::to_string(mesh.triangle_count()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
    file.write_raw<char>(header);
    for (size_t i = 0; i < places.positions.size(); i += 3) {
      file.write_raw(std::span(places.positions).subspan(i, 3));
      file.write_raw(std::span(normals).subspan(i, 3));
    }
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      file.write(std::array<uint8_t, 1>{3});
      const std::array<uint32_t, 3> corners{places.place[mesh.indices[i]], places.place[mesh.indices[i + 1]],
                                            places.place[mesh.indices[i + 2]]};
      file.write_raw<uint32_t>(corners);
    }
    file.close();
  });
}

void write_stl(const Mesh& all, const std::string& path) {
  const MeshPart& mesh = all.parts[0];
  const std::array<float, 3> offset{static_cast<float>(all.offset.x), static_cast<float>(all.offset.y), 0.0F};
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    std::array<char, 80> header{};
    constexpr std::string_view kTitle = "Terrain, metres, z up";
    std::copy(kTitle.begin(), kTitle.end(), header.begin());
    file.write_raw<char>(header);
    file.write_raw<uint32_t>(std::array{static_cast<uint32_t>(mesh.triangle_count())});
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      std::array<float, 12> facet{};
      for (size_t k = 0; k < 9; ++k)
        facet[3 + k] = mesh.positions[3 * size_t{mesh.indices[i + k / 3]} + k % 3] + offset[k % 3];
      const float ux = facet[6] - facet[3], uy = facet[7] - facet[4], uz = facet[8] - facet[5];
      const float vx = facet[9] - facet[3], vy = facet[10] - facet[4], vz = facet[11] - facet[5];
      const std::array<float, 3> n{uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
      const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (size_t k = 0; k < 3; ++k) facet[k] = length > 0 ? n[k] / length : 0.0F;
      file.write_raw<float>(facet);
      file.write(std::array<uint8_t, 2>{});
    }
    file.close();
  });
}

void write_mesh(const Mesh& mesh, const std::string& path, const MeshFileOptions& options) {
  const std::string extension = extension_of(path);
  const std::vector<std::string> known = {".glb", ".obj", ".ply", ".stl"};
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw IoError(path, "'" + extension + "' is not a mesh format" + suggestion(extension, known));
  if (mesh.parts.empty() || mesh.parts[0].indices.empty()) throw InvalidArgument("mesh", "has no triangles");
  if (extension == ".glb") write_glb(mesh, path, options);
  if (extension == ".obj") write_obj(mesh, path, options);
  if (extension == ".ply") write_ply(mesh, path);
  if (extension == ".stl") write_stl(mesh, path);
}

}  // namespace seamount::io

// OBJ, PLY and STL; GLB is mesh_glb.cpp.
#include "seamount/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

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

}  // namespace

void write_obj(const MeshPart& mesh, const std::string& path, const MeshFileOptions& options) {
  const std::filesystem::path stem = std::filesystem::path(path).replace_extension();
  const std::string name = stem.filename().string();
  if (options.texture != nullptr) write_png(*options.texture, stem.string() + ".png");
  write_text(stem.string() + ".mtl", "newmtl terrain\nKd 0.8 0.8 0.8\nKs 0 0 0\n" +
                                         (options.texture != nullptr ? "map_Kd " + name + ".png\n" : ""));
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    TextWriter text(file);
    text << "# metres, y up, sea level at y = 0\nmtllib " << name << ".mtl\no terrain\nusemtl terrain\n";
    for (size_t i = 0; i < mesh.positions.size(); i += 3)
      text << "v " << mesh.positions[i] << " " << mesh.positions[i + 2] << " " << 0.0F - mesh.positions[i + 1] << "\n";
    for (size_t i = 0; i < mesh.uvs.size(); i += 2)
      text << "vt " << mesh.uvs[i] << " " << 1.0F - mesh.uvs[i + 1] << "\n";
    for (size_t i = 0; i < mesh.normals.size(); i += 3)
      text << "vn " << mesh.normals[i] << " " << mesh.normals[i + 2] << " " << 0.0F - mesh.normals[i + 1] << "\n";
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
      const uint32_t v = mesh.indices[i] + 1;
      text << (i % 3 == 0 ? "f " : " ") << v << "/" << v << "/" << v << (i % 3 == 2 ? "\n" : "");
    }
    text.flush();
    file.close();
  });
}

void write_ply(const MeshPart& mesh, const std::string& path) {
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    const std::string header =
        "ply\nformat binary_little_endian 1.0\ncomment metres, z up, sea level at z = 0\nelement vertex " +
        std::to_string(mesh.vertex_count()) +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
        "property float ny\nproperty float nz\nelement face " +
        std::to_string(mesh.triangle_count()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
    file.write_raw<char>(header);
    for (size_t i = 0; i < mesh.positions.size(); i += 3) {
      file.write_raw(std::span(mesh.positions).subspan(i, 3));
      file.write_raw(std::span(mesh.normals).subspan(i, 3));
    }
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      file.write(std::array<uint8_t, 1>{3});
      file.write_raw(std::span(mesh.indices).subspan(i, 3));
    }
    file.close();
  });
}

void write_stl(const MeshPart& mesh, const std::string& path) {
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    std::array<char, 80> header{};
    constexpr std::string_view kTitle = "Terrain, metres, z up";
    std::copy(kTitle.begin(), kTitle.end(), header.begin());
    file.write_raw<char>(header);
    file.write_raw<uint32_t>(std::array{static_cast<uint32_t>(mesh.triangle_count())});
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      std::array<float, 12> facet{};
      for (size_t k = 0; k < 9; ++k) facet[3 + k] = mesh.positions[3 * size_t{mesh.indices[i + k / 3]} + k % 3];
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
  if (extension == ".obj") write_obj(mesh.parts[0], path, options);
  if (extension == ".ply") write_ply(mesh.parts[0], path);
  if (extension == ".stl") write_stl(mesh.parts[0], path);
}

}  // namespace seamount::io

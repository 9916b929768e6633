// One writer per mesh format. Not part of the public interface.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/io/mesh_file.h"

namespace seamount::io {

/// glTF 2.0 binary: a primitive and a material for each part, the texture inside.
void write_glb(const Mesh& mesh, const std::string& path, const MeshFileOptions& options);

/// Text, with "name.mtl" and "name.png" beside it.
void write_obj(const Mesh& mesh, const std::string& path, const MeshFileOptions& options);

/// Binary, with normals.
void write_ply(const Mesh& mesh, const std::string& path);

/// Binary; a facet's normal is computed from its corners.
void write_stl(const Mesh& mesh, const std::string& path);

/// Places of a part's vertices, each once, so that neighbours share them where normals differ too.
struct WeldedPlaces {
  std::vector<float> positions;  ///< with the mesh's offset
  std::vector<uint32_t> place;   ///< of each vertex
};
WeldedPlaces welded(const MeshPart& part, Vec2 offset);

}  // namespace seamount::io

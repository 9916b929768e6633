// One writer per mesh format. Not part of the public interface.
#pragma once

#include <string>

#include "seamount/io/mesh_file.h"

namespace seamount::io {

/// glTF 2.0 binary: a primitive and a material for each part, the texture inside.
void write_glb(const Mesh& mesh, const std::string& path, const MeshFileOptions& options);

/// Text, with "name.mtl" and "name.png" beside it.
void write_obj(const MeshPart& mesh, const std::string& path, const MeshFileOptions& options);

/// Binary, with normals.
void write_ply(const MeshPart& mesh, const std::string& path);

/// Binary; a facet's normal is computed from its corners.
void write_stl(const MeshPart& mesh, const std::string& path);

}  // namespace seamount::io

// One writer per mesh format. Not part of the public interface.
#pragma once

#include <string>

#include "seamount/io/mesh.h"

namespace seamount::io {

/// glTF 2.0 binary: one material with the texture inside, and the water as a second primitive.
void write_glb(const TerrainMesh& mesh, const HeightField& heights, const std::string& path,
               const MeshOptions& options);

/// Text, with "name.mtl" and "name.png" beside it.
void write_obj(const TerrainMesh& mesh, const std::string& path, const MeshOptions& options);

/// Binary, with normals.
void write_ply(const TerrainMesh& mesh, const std::string& path);

/// Binary; a facet's normal is computed from its corners.
void write_stl(const TerrainMesh& mesh, const std::string& path);

}  // namespace seamount::io

// Meshes as files: GLB (glTF 2.0 binary), OBJ, PLY, STL. GLB and OBJ have y up, x east, z south; PLY and STL have z up,
// x east, y north.
#pragma once

#include <string>

#include "seamount/io/provenance.h"
#include "seamount/model/image.h"
#include "seamount/model/mesh.h"

namespace seamount::io {

struct MeshFileOptions {
  const Image* texture = nullptr;  ///< draped over the whole ground, row 0 north; GLB and OBJ only
  Provenance provenance = {};      ///< GLB only
};

/// By extension: .glb, .obj (with .mtl and .png beside it), .ply, .stl (both binary). GLB holds all parts, the others
/// the first. A solid's neighbours share places of vertices, so that it is closed for every program; only GLB has
/// vertices of each normal. A mesh's offset is a translation in GLB, and is added to the positions in the others.
/// Throws IoError; InvalidArgument{"mesh"} if it has no triangles.
void write_mesh(const Mesh& mesh, const std::string& path, const MeshFileOptions& options = {});

}  // namespace seamount::io

// Terrain as a triangle mesh: GLB (glTF 2.0 binary), OBJ, PLY, STL.
//
// Vertices are the cells' centres, relative to the middle of the terrain, in metres. GLB and OBJ have y up, x east, z
// south; PLY and STL have z up, x east, y north.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/io/provenance.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"

namespace seamount::io {

struct MeshOptions {
  int64_t max_triangles = 0;    ///< 0: all; else simplified to about as many. The border is kept sample by sample, so
                                ///< that tiles fit, and bounds how few triangles there can be.
  double vertical_scale = 1.0;  ///< > 0
  double base_m = 0.0;          ///< > 0: a closed solid whose flat bottom lies so far below the lowest height, to print
  bool water = true;            ///< GLB only: a translucent surface at sea level if any height is below it
  const Image* texture = nullptr;  ///< draped over the whole terrain, row 0 north; GLB and OBJ only
  Provenance provenance;
};

/// An indexed triangle mesh, z up, counter-clockwise seen from outside.
struct TerrainMesh {
  std::vector<float> positions;  ///< x east, y north, z up; 3 a vertex
  std::vector<float> normals;    ///< 3 a vertex, unit length; of the full terrain, also after simplification
  std::vector<float> uvs;        ///< 2 a vertex; (0, 0) is the north-west corner of the texture
  std::vector<uint32_t> indices;
  size_t vertex_count() const { return positions.size() / 3; }
  size_t triangle_count() const { return indices.size() / 3; }
};

/// Throws InvalidArgument for a terrain less than two cells wide or high. Grids of more than 6 times max_triangles are
/// thinned evenly first (the outer samples stay). Simplification: quadric error (meshoptimizer), about 1 s for a
/// million triangles.
TerrainMesh make_mesh(const HeightField& heights, const MeshOptions& options, const RunContext& run);

/// By extension: .glb, .obj (with .mtl and .png beside it), .ply, .stl (both binary). Throws IoError.
void write_mesh(const HeightField& heights, const std::string& path, const MeshOptions& options, const RunContext& run);

}  // namespace seamount::io

// Terrain as a triangle mesh: a vertex per cell centre, relative to the middle of the terrain; simplified, closed to a
// solid or covered by water on demand. io/mesh_file.h writes it.
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/mesh.h"

namespace seamount::geom {

struct MeshOptions {
  int64_t max_triangles = 0;    ///< 0: all; else simplified to about as many. The border is kept sample by sample, so
                                ///< that tiles fit, and bounds how few triangles there can be.
  double vertical_scale = 1.0;  ///< > 0
  double base_m = 0.0;          ///< > 0: a closed solid whose flat bottom lies so far below the lowest height, to print
  bool water = true;            ///< a second part at sea level if any height is below it
};

/// The terrain's part first; its normals are those of the full terrain, also after simplification. Throws
/// InvalidArgument for options out of range, a height that is not finite, or a terrain less than two cells wide or
/// high. Grids of more than 6 times max_triangles are thinned evenly first (the outer samples stay). Simplification:
/// quadric error (meshoptimizer), about 1 s for a million triangles.
Mesh make_mesh(const HeightField& heights, const MeshOptions& options, const RunContext& run);

}  // namespace seamount::geom

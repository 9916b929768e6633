// Coarser meshes by joining all vertices in a cell of a lattice (Rossignac and Borrel, "Multi-resolution 3D
// approximations for rendering complex scenes", 1993): rough, never fails, for what is seen from afar.
#pragma once

#include "seamount/model/things.h"

namespace seamount::geom {

/// At most `most` triangles, all of them leaves: a clustered surface need not be closed. REQUIRES: most >= 12.
ThingMesh cluster_mesh(const ThingMesh& mesh, size_t most);

}  // namespace seamount::geom

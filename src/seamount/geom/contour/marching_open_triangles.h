// Lines of constant height on triangles, as chains that may end at the triangles' outer border (P2 sec. 4.4). For a
// piece of ground whose lines are then joined to those around it; marching_triangles.h closes them instead.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {

/// A surface of triangles, counter-clockwise.
struct HeightMesh {
  std::vector<Vec2> nodes;
  std::vector<double> height_m;
  std::vector<std::array<int32_t, 3>> triangles;
};

/// Higher ground is on the left. A node counts as above a level that it equals, and is itself where the line passes.
struct LevelChain {
  double height_m;
  bool closed;
  Polyline points;          ///< a closed chain does not repeat its first
  int32_t first_node = -1;  ///< of an open chain: the higher node of the edge that it starts on
  int32_t last_node = -1;   ///< and of the one that it ends on
};

/// All chains at all levels, open ones first, each kind by level and by the nodes of the edge that it starts on.
/// REQUIRES: levels ascend; edges belong to at most two triangles. n log n in what is made.
std::vector<LevelChain> march_open_triangles(const HeightMesh& mesh, const std::vector<double>& levels,
                                             const RunContext& run = {});

}  // namespace seamount::geom

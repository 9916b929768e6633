// Which nodes of a network are neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"

namespace seamount::geom {

struct NodeGraph {
  std::vector<uint32_t> starts;     ///< of each node's neighbours; one more at the end
  std::vector<int32_t> neighbours;  ///< ascending for each node

  std::span<const int32_t> around(size_t node) const {
    return {neighbours.data() + starts[node], neighbours.data() + starts[node + 1]};
  }
};

/// The nodes that share a triangle's side with each node. REQUIRES: triangles name nodes below `nodes`. Linear.
NodeGraph make_node_graph(std::span<const std::array<int32_t, 3>> triangles, size_t nodes, const RunContext& run = {});

}  // namespace seamount::geom

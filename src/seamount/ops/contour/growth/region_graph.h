// Which nodes of a network growth may step to, and where regions meet (P2 sec. 4.3, 4.5).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

/// What lies beyond a region's border, seen from the region.
enum class Side {
  lower,   ///< ground that the region drains to: what surrounds a hill, a basin inside it
  upper,   ///< ground that drains into the region: a hill inside it, what surrounds a basin
  across,  ///< another region inside the same one, too near for nodes in between: neither, but down the hill
};

/// A node beside a node of another region. Sorted by node, each pair once.
struct BorderNode {
  int32_t node = 0;
  int32_t beyond = -1;  ///< the child of the node's region that the other node is in; -1: over the region's own outline
  Side side = Side::lower;
  auto operator<=>(const BorderNode&) const = default;
};

struct RegionGraph {
  std::vector<uint32_t> starts;                  ///< of each node's neighbours; one more at the end
  std::vector<int32_t> neighbours;               ///< in the same region
  std::vector<uint32_t> firsts;                  ///< of each region's nodes in `nodes`; one more at the end
  std::vector<int32_t> nodes;                    ///< by region, ascending; nodes outside all regions are in none
  std::vector<std::vector<BorderNode>> borders;  ///< by region
  std::vector<int32_t> rim;                      ///< nodes of regions at the edge of the network, ascending

  std::span<const int32_t> around(int32_t node) const {
    const auto n = static_cast<size_t>(node);
    return {neighbours.data() + starts[n], neighbours.data() + starts[n + 1]};
  }
  std::span<const int32_t> members(size_t region) const {
    return {nodes.data() + firsts[region], nodes.data() + firsts[region + 1]};
  }
};

/// What is on the other side of region `here`'s border where the node beyond it lies in region `there` (-1: outside).
BorderNode border_of(const std::vector<TinRegion>& regions, int32_t here, int32_t there);

/// REQUIRES: triangles of one orientation, each directed edge at most once; region per node in [-1, regions). Linear.
RegionGraph make_region_graph(std::span<const std::array<int32_t, 3>> triangles, std::span<const int32_t> region,
                              const std::vector<TinRegion>& regions, const RunContext& run);

}  // namespace seamount::contour

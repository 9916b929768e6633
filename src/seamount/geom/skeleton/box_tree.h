// A balanced tree of boxes, halved again and again across the longer side of their middles: what search in it costs
// does not depend on how unevenly the boxes lie, many in one place included.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {

class BoxTree {
 public:
  struct Node {
    Vec2 low, high;
    uint32_t first;  ///< leaf: where its boxes begin in order(); else the number of its second child
    uint32_t count;  ///< leaf: how many; else 0, and the first child is the node that follows
  };
  static constexpr uint32_t kLeaf = 6;
  /// Deeper than any tree of 2^32 boxes: a stack of this size holds every search.
  static constexpr size_t kDepth = 40;

  BoxTree() = default;
  /// About n log n. REQUIRES: finite, none empty().
  explicit BoxTree(const std::vector<Box>& boxes);

  /// In preorder; empty without boxes.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Numbers of boxes, leaf by leaf.
  const std::vector<uint32_t>& order() const { return order_; }

 private:
  uint32_t build(const std::vector<Box>& boxes, uint32_t begin, uint32_t end);

  std::vector<Node> nodes_;
  std::vector<uint32_t> order_;
};

inline double squared_distance(const BoxTree::Node& node, Vec2 p) {
  const double x = std::max({node.low.x - p.x, p.x - node.high.x, 0.0});
  const double y = std::max({node.low.y - p.y, p.y - node.high.y, 0.0});
  return x * x + y * y;
}

}  // namespace seamount::geom

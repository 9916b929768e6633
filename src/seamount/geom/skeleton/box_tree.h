// A balanced tree of boxes, halved again and again across the longer side of their middles: what search in it costs
// does not depend on how unevenly the boxes lie, many in one place included.
#pragma once

#include <algorithm>
#include <array>
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
  /// Calls visit(number) for the boxes of all leaves that hold a place: those that do, and a few neighbours.
  template <class Visit>
  void for_each_at(Vec2 place, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::array<uint32_t, kDepth> stack;
    size_t waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const uint32_t number = stack[--waiting];
      const Node& node = nodes_[number];
      if (place.x < node.low.x || place.y < node.low.y || place.x > node.high.x || place.y > node.high.y) continue;
      if (node.count == 0) {
        stack[waiting++] = node.first;
        stack[waiting++] = number + 1;
      } else {
        for (uint32_t k = node.first; k < node.first + node.count; ++k) visit(order_[k]);
      }
    }
  }
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

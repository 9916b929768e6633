// See box_tree.h.
#include "seamount/geom/skeleton/box_tree.h"

#include <numeric>

namespace seamount::geom {

BoxTree::BoxTree(const std::vector<Box>& boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(boxes.size() / 2 + 1);
  if (!boxes.empty()) build(boxes, 0, static_cast<uint32_t>(boxes.size()));
}

uint32_t BoxTree::build(const std::vector<Box>& boxes, uint32_t begin, uint32_t end) {
  Box all = boxes[order_[begin]];
  Box middles = {all.low + all.high, all.low + all.high};  // doubled
  for (uint32_t i = begin; i < end; ++i) {
    const Box& box = boxes[order_[i]];
    const Vec2 middle = box.low + box.high;
    all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y)};
    all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y)};
    middles.low = {std::min(middles.low.x, middle.x), std::min(middles.low.y, middle.y)};
    middles.high = {std::max(middles.high.x, middle.x), std::max(middles.high.y, middle.y)};
  }
  const uint32_t number = static_cast<uint32_t>(nodes_.size());
  nodes_.push_back({all.low, all.high, begin, end - begin});
  if (end - begin <= kLeaf) return number;
  const uint32_t half = begin + (end - begin) / 2;
  const bool across_x = middles.high.x - middles.low.x >= middles.high.y - middles.low.y;
  const auto key = [&](uint32_t i) {
    return across_x ? boxes[i].low.x + boxes[i].high.x : boxes[i].low.y + boxes[i].high.y;
  };
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end, [&](uint32_t a, uint32_t b) {
    const double ka = key(a), kb = key(b);
    return ka < kb || (ka == kb && a < b);
  });
  nodes_[number].count = 0;
  build(boxes, begin, half);
  const uint32_t second = build(boxes, half, end);
  nodes_[number].first = second;
  return number;
}

}  // namespace seamount::geom

#include "seamount/geom/mesh/bvh.h"

#include <cmath>
#include <numeric>

namespace seamount::geom {
namespace {

constexpr size_t kBins = 16;
constexpr int kHalveFrom = 40;  // so deep, sets are halved: the tree ends

float area(const Box3& box) {
  const float x = box.high[0] - box.low[0], y = box.high[1] - box.low[1], z = box.high[2] - box.low[2];
  return x < 0.0F ? 0.0F : x * y + y * z + z * x;
}

float middle(const Box3& box, size_t axis) { return 0.5F * (box.low[axis] + box.high[axis]); }

}  // namespace

/// Where to cut a set of items: those whose middle lies in a bin below `bin` go left.
struct Bvh::Split {
  size_t axis = 0, bin = 0;
  float cost = Box3::kFar, low = 0.0F, scale = 0.0F;

  size_t bin_of(const Box3& box) const {
    return std::min(kBins - 1, static_cast<size_t>(std::max(0.0F, (middle(box, axis) - low) * scale)));
  }

  static Split best(std::span<const uint32_t> items, std::span<const Box3> boxes) {
    Box3 middles;
    for (const uint32_t item : items)
      middles.include(std::array{middle(boxes[item], 0), middle(boxes[item], 1), middle(boxes[item], 2)});
    Split best;
    for (size_t axis = 0; axis < 3; ++axis) {
      Split split;
      split.axis = axis;
      split.low = middles.low[axis];
      const float width = middles.high[axis] - middles.low[axis];
      if (!(width > 0.0F)) continue;
      split.scale = static_cast<float>(kBins) / width;
      std::array<Box3, kBins> bins{};
      std::array<uint32_t, kBins> counts{};
      for (const uint32_t item : items) {
        const size_t bin = split.bin_of(boxes[item]);
        bins[bin].include(boxes[item]);
        ++counts[bin];
      }
      std::array<float, kBins> right{};
      Box3 sum;
      uint32_t count = 0;
      for (size_t i = kBins - 1; i > 0; --i) {
        sum.include(bins[i]);
        count += counts[i];
        right[i] = count == 0 ? Box3::kFar : area(sum) * static_cast<float>(count);
      }
      sum = {};
      count = 0;
      for (size_t i = 1; i < kBins; ++i) {
        sum.include(bins[i - 1]);
        count += counts[i - 1];
        if (count == 0) continue;
        split.bin = i;
        split.cost = area(sum) * static_cast<float>(count) + right[i];
        if (split.cost < best.cost) best = split;
      }
    }
    return best;
  }
};

Bvh::Bvh(std::span<const Box3> boxes, uint32_t leaf) : order_(boxes.size()), leaf_(leaf) {
  if (boxes.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(2 * boxes.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<uint32_t>(boxes.size()), 0, boxes);
}

/// Orders a set of items so that the first go left, and gives how many; 0: they stay together.
uint32_t Bvh::cut(uint32_t first, uint32_t count, const Box3& box, int depth, std::span<const Box3> boxes) {
  if (count == 1) return 0;
  const uint32_t half = count > leaf_ ? count / 2 : 0;
  if (depth >= kHalveFrom) return half;
  const auto items = std::span(order_).subspan(first, count);
  const Split split = Split::best(items, boxes);
  if (!std::isfinite(split.cost)) return half;  // all in one place
  const bool worth = split.cost + area(box) < area(box) * static_cast<float>(count);
  if (!worth && count <= leaf_) return 0;
  const auto middle = std::stable_partition(items.begin(), items.end(),
                                            [&](uint32_t item) { return split.bin_of(boxes[item]) < split.bin; });
  const auto left = static_cast<uint32_t>(middle - items.begin());
  return left == count ? half : left;
}

void Bvh::build(uint32_t node, uint32_t first, uint32_t count, int depth, std::span<const Box3> boxes) {
  Box3 box;
  for (uint32_t i = first; i < first + count; ++i) box.include(boxes[order_[i]]);
  nodes_[node].box = box;
  const uint32_t left = cut(first, count, box, depth, boxes);
  if (left == 0) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  const auto children = static_cast<uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  build(children, first, left, depth + 1, boxes);
  build(children + 1, first + left, count - left, depth + 1, boxes);
}

}  // namespace seamount::geom

#include "seamount/geom/polygon/lattice_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace seamount::geom {
namespace {

constexpr int kCurveBits = 16;

/// Position of a cell on the Hilbert curve that runs from one lower corner of the square to the other.
uint32_t hilbert_index(uint32_t x, uint32_t y) {
  // By state and quadrant (2 x bit + y bit): the quadrant's place on the curve, and the state inside it.
  constexpr std::array<std::array<uint8_t, 4>, 4> kPlace = {{{0, 1, 3, 2}, {0, 3, 1, 2}, {2, 3, 1, 0}, {2, 1, 3, 0}}};
  constexpr std::array<std::array<uint8_t, 4>, 4> kNext = {{{1, 0, 3, 0}, {0, 2, 1, 1}, {2, 1, 2, 3}, {3, 3, 0, 2}}};
  uint32_t index = 0;
  size_t state = 0;
  for (int bit = kCurveBits - 1; bit >= 0; --bit) {
    const size_t quadrant = 2 * ((x >> bit) & 1U) + ((y >> bit) & 1U);
    index = (index << 2) | kPlace[state][quadrant];
    state = kNext[state][quadrant];
  }
  return index;
}

struct Keyed {
  uint32_t key;
  int32_t index;
};

/// Stable radix sort by key.
void sort_by_key(std::vector<Keyed>& items, const RunContext& run) {
  constexpr int kBits = 11;
  std::vector<Keyed> other(items.size());
  for (int shift = 0; shift < 2 * kCurveBits; shift += kBits) {
    std::array<size_t, size_t{1} << kBits> starts{};
    const auto digit = [&](const Keyed& item) { return (item.key >> shift) & ((1U << kBits) - 1); };
    run.check_cancelled();
    for (const Keyed& item : items) ++starts[digit(item)];
    size_t sum = 0;
    for (size_t& start : starts) {
      const size_t count = start;
      start = sum;
      sum += count;
    }
    for (const Keyed& item : items) other[starts[digit(item)]++] = item;
    items.swap(other);
  }
}

}  // namespace

Lattice snap(std::span<const Vec2> points, std::vector<LatticePoint>& snapped) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  Vec2 low{kInf, kInf}, high{-kInf, -kInf};
  for (const Vec2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double extent = points.empty() ? 0.0 : std::max(high.x - low.x, high.y - low.y);
  const Lattice lattice{points.empty() ? Vec2{} : low, extent > 0.0 ? extent / (kLatticeEnd - 1) : 1.0};
  const auto nearest = [&](double offset) {
    return static_cast<int32_t>(std::clamp(std::floor(offset / lattice.unit_m + 0.5), 0.0, kLatticeEnd - 1.0));
  };
  snapped.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    snapped[i] = {nearest(points[i].x - lattice.origin.x), nearest(points[i].y - lattice.origin.y)};
  }
  return lattice;
}

std::vector<int32_t> spatial_order(std::span<const LatticePoint> points, const RunContext& run) {
  LatticePoint low{kLatticeEnd, kLatticeEnd}, high{0, 0};
  for (const LatticePoint p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto extent = static_cast<uint32_t>(points.empty() ? 0 : std::max(high.x - low.x, high.y - low.y));
  const int shift = std::max(0, static_cast<int>(std::bit_width(extent)) - kCurveBits);
  std::vector<Keyed> items(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    const auto x = static_cast<uint32_t>(points[i].x - low.x) >> shift;
    const auto y = static_cast<uint32_t>(points[i].y - low.y) >> shift;
    items[i] = {hilbert_index(x, y), static_cast<int32_t>(i)};
  }
  sort_by_key(items, run);
  std::vector<int32_t> order(points.size());
  for (size_t i = 0; i < points.size(); ++i) order[i] = items[i].index;
  return order;
}

}  // namespace seamount::geom

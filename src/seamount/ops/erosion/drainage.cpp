#include "seamount/ops/erosion/drainage.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/facet.h"

namespace seamount::erosion {
namespace {

constexpr double kGradient = 0.005;  // of a river along the border
constexpr size_t kMinPart = 1 << 13, kMostParts = 100;

/// Border cells in order around the map.
std::vector<int32_t> ring_of(const GridFrame& frame) {
  const int w = frame.width, h = frame.height;
  std::vector<int32_t> ring;
  ring.reserve(2 * static_cast<size_t>(w) + 2 * static_cast<size_t>(h));
  for (int x = 0; x < w; ++x) ring.push_back(x);
  for (int y = 1; y < h; ++y) ring.push_back(y * w + w - 1);
  for (int x = w - 2; x >= 0 && h > 1; --x) ring.push_back((h - 1) * w + x);
  for (int y = h - 2; y >= 1 && w > 1; --y) ring.push_back(y * w);
  return ring;
}

}  // namespace

Grid<uint8_t> border_outlets(const HeightField& surface, double reach_m) {
  const std::vector<int32_t> ring = ring_of(surface.frame());
  const auto count = static_cast<int64_t>(ring.size());
  const int64_t reach =
      std::clamp<int64_t>(std::llround(reach_m / surface.cell_m()), 1, std::max<int64_t>(1, count / 2));
  const auto height = [&](int64_t k) { return surface.data()[ring[(k + count) % count]]; };
  const auto slack = static_cast<float>(kGradient * static_cast<double>(reach) * surface.cell_m());
  Grid<uint8_t> outlets(surface.frame(), 0);
  std::deque<int64_t> lowest;  // candidates of the window, heights rising
  for (int64_t k = -reach; k < count + reach; ++k) {
    while (!lowest.empty() && height(lowest.back()) >= height(k)) lowest.pop_back();
    lowest.push_back(k);
    const int64_t middle = k - reach;
    if (lowest.front() < middle - reach) lowest.pop_front();
    if (middle < 0 || middle >= count) continue;
    if (height(middle) <= height(lowest.front()) + slack) outlets.data()[ring[middle]] = 1;
  }
  return outlets;
}

Grid<uint8_t> refined_outlets(const Grid<uint8_t>& coarse, const HeightField& fine) {
  const std::vector<int32_t> ring = ring_of(fine.frame());
  const int width = fine.width();
  const auto slack = static_cast<float>(kGradient * fine.cell_m());
  Grid<float> lowest(coarse.frame(), std::numeric_limits<float>::infinity());
  const auto lowest_at = [&](int32_t cell) -> float& { return lowest(cell % width / 2, cell / width / 2); };
  for (const int32_t cell : ring) lowest_at(cell) = std::min(lowest_at(cell), fine.data()[cell]);
  Grid<uint8_t> outlets(fine.frame(), 0);
  for (const int32_t cell : ring) {
    const bool inherited = coarse(cell % width / 2, cell / width / 2) != 0;
    if (inherited && fine.data()[cell] <= lowest_at(cell) + slack) outlets.data()[cell] = 1;
  }
  return outlets;
}

void Drainage::choose_receivers(const HeightField& surface, const Grid<uint8_t>& outlets, const Sea& sea,
                                std::optional<Seed> seed, const RunContext& run) {
  const int width = surface.width(), height = surface.height();
  const float* z = surface.data();
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto cell = static_cast<size_t>(y) * width + x;
        uint8_t& chosen = direction_.data()[cell];
        chosen = geom::kOutlet;
        if (outlets.data()[cell] != 0 || sea.covers(cell, z[cell])) continue;
        const bool inner = x > 0 && y > 0 && x < width - 1 && y < height - 1;
        std::array<float, 8> fall = {};
        for (int d = 0; d < 8; ++d) {
          if (!inner && !surface.contains(x + geom::kFlowDx[d], y + geom::kFlowDy[d])) continue;
          const auto other = static_cast<size_t>(static_cast<int64_t>(cell) + offset_[d]);
          fall[d] = z[cell] - (sea.covers(other, z[other]) ? sea.level_m : z[other]);
        }
        chosen = geom::steepest_facet(fall, seed ? geom::facet_draw(*seed, cell) : 0.5F);
      }
    }
  });
}

void Drainage::order_trees(const RunContext& run) {
  const int width = direction_.width(), height = direction_.height();
  std::vector<int32_t> stack;
  size_t done = 0;
  for (int y = 0; y < height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < width; ++x) {
      if (direction_(x, y) != geom::kOutlet) continue;
      stack.push_back(y * width + x);
      while (!stack.empty()) {
        const int32_t cell = stack.back();
        stack.pop_back();
        order_[done++] = cell;
        const int cx = cell % width, cy = cell / width;
        const bool inner = cx > 0 && cy > 0 && cx < width - 1 && cy < height - 1;
        for (int d = 0; d < 8; ++d) {
          if (!inner && !direction_.contains(cx + geom::kFlowDx[d], cy + geom::kFlowDy[d])) continue;
          if (direction_.data()[cell + offset_[d]] == (d ^ 4)) stack.push_back(cell + offset_[d]);
        }
      }
    }
  }
}

void Drainage::divide(ScalarField& upstream) {
  const size_t size = std::max(kMinPart, order_.size() / kMostParts);
  float* count = upstream.data();
  std::fill(upstream.cells().begin(), upstream.cells().end(), 1.0F);
  for (size_t k = order_.size(); k-- > 0;) {
    if (!is_root(order_[k])) count[receiver(order_[k])] += count[order_[k]];
  }
  // The trunk moves to the front. What lies behind it stays in order, so that catchments are runs of it.
  std::vector<int32_t> trunk;
  size_t free = order_.size();
  for (size_t k = order_.size(); k-- > 0;) {
    if (count[order_[k]] > static_cast<float>(size)) {
      trunk.push_back(order_[k]);
    } else {
      order_[--free] = order_[k];
    }
  }
  std::reverse_copy(trunk.begin(), trunk.end(), order_.begin());
  for (const int32_t cell : trunk) part_of_.data()[cell] = kTrunk;
  part_begins_.assign(1, free);
  for (size_t k = free; k < order_.size();) {
    if (k - part_begins_.back() >= size) part_begins_.push_back(k);
    const size_t end = k + static_cast<size_t>(count[order_[k]]);
    for (; k < end; ++k) part_of_.data()[order_[k]] = static_cast<uint8_t>(part_begins_.size() - 1);
  }
  part_begins_.push_back(order_.size());
}

void Drainage::route(const HeightField& surface, const Grid<uint8_t>& outlets, const Sea& sea, std::optional<Seed> seed,
                     ScalarField& room, const RunContext& run) {
  const GridFrame& frame = surface.frame();
  if (!(direction_.frame() == frame)) {
    direction_ = Grid<uint8_t>(frame);
    part_of_ = Grid<uint8_t>(frame);
    order_.resize(surface.size());
    for (size_t d = 0; d < 8; ++d) {
      offset_[d] = static_cast<int32_t>(geom::flow_steps(frame.width)[d]);
      distance_[d] = static_cast<float>(frame.cell_m) * geom::kFlowLength[d];
    }
  }
  choose_receivers(surface, outlets, sea, seed, run);
  geom::route_through_pits(surface, direction_, std::numeric_limits<float>::infinity(), run);
  order_trees(run);
  divide(room);
}

}  // namespace seamount::erosion

// The landscape evolution model that geomorphologists measure with, plain: the judge of erosion.run's steady states.
//
// Braun and Willett 2013: water runs to the steepest of eight neighbours, depressions over their lowest pass (priority
// flood, Barnes, Lehman and Mulla 2014), and dh/dt = U - K sqrt(A) dh/dx is one backward Euler step from the outlets
// up.
#pragma once

#include <cmath>
#include <cstdint>
#include <queue>
#include <vector>

#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::erosion {

struct FastScape {
  double erodibility = 1e-5;  ///< K, 1/yr
  double uplift_m_yr = 1e-3;
  double years = 1e6;
  int steps = 200;
};

/// Cells in an order in which each comes after its receiver, which is itself where water leaves.
struct Ways {
  std::vector<int32_t> order, receiver;
  std::vector<double> distance_m;
};

inline Ways fastscape_ways(const HeightField& z, const Grid<uint8_t>& outlets) {
  using Item = std::pair<float, int32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::vector<float> water(z.size(), -INFINITY);
  Ways ways{{}, std::vector<int32_t>(z.size(), -1), std::vector<double>(z.size(), 0.0)};
  const auto push = [&](int32_t cell, int32_t from, float level) {
    water[static_cast<size_t>(cell)] = level;
    ways.receiver[static_cast<size_t>(cell)] = from;
    queue.push({level, cell});
  };
  for (int32_t i = 0; i < static_cast<int32_t>(z.size()); ++i) {
    if (outlets.data()[i] != 0) push(i, i, z.data()[i]);
  }
  while (!queue.empty()) {
    const int32_t cell = queue.top().second;
    queue.pop();
    ways.order.push_back(cell);
    const int x = cell % z.width(), y = cell / z.width();
    double steepest = 0.0;
    for (int d = 0; d < 8; ++d) {
      const int nx = x + geom::kFlowDx[d], ny = y + geom::kFlowDy[d];
      if (!z.contains(nx, ny)) continue;
      const int32_t other = ny * z.width() + nx;
      if (water[static_cast<size_t>(other)] == -INFINITY) {
        push(other, cell, std::max(water[static_cast<size_t>(cell)], z.data()[other]));
      } else if (outlets.data()[cell] == 0) {
        const double fall =
            (water[static_cast<size_t>(cell)] - water[static_cast<size_t>(other)]) / geom::kFlowLength[d];
        if (fall > steepest) steepest = fall, ways.receiver[static_cast<size_t>(cell)] = other;
      }
    }
    const int32_t to = ways.receiver[static_cast<size_t>(cell)];
    ways.distance_m[static_cast<size_t>(cell)] = std::hypot(x - to % z.width(), y - to / z.width()) * z.cell_m();
  }
  return ways;
}

/// Cells upstream of each, itself included.
inline std::vector<double> fastscape_area(const Ways& ways) {
  std::vector<double> cells(ways.order.size(), 1.0);
  for (size_t k = ways.order.size(); k-- > 0;) {
    const auto cell = static_cast<size_t>(ways.order[k]), to = static_cast<size_t>(ways.receiver[cell]);
    if (to != cell) cells[to] += cells[cell];
  }
  return cells;
}

/// Outlets keep their height.
inline HeightField fastscape(HeightField z, const Grid<uint8_t>& outlets, const FastScape& params) {
  const double dt = params.years / params.steps;
  std::vector<double> h(z.cells().begin(), z.cells().end());
  for (int step = 0; step < params.steps; ++step) {
    for (size_t i = 0; i < h.size(); ++i) {
      if (outlets.data()[i] == 0) h[i] += params.uplift_m_yr * dt;
      z.data()[i] = static_cast<float>(h[i]);
    }
    const Ways ways = fastscape_ways(z, outlets);
    const std::vector<double> cells = fastscape_area(ways);
    for (const int32_t at : ways.order) {
      const auto cell = static_cast<size_t>(at), to = static_cast<size_t>(ways.receiver[cell]);
      if (to == cell || h[cell] <= h[to]) continue;
      const double rate = params.erodibility * dt * std::sqrt(cells[cell]) * z.cell_m() / ways.distance_m[cell];
      h[cell] = (h[cell] + rate * h[to]) / (1.0 + rate);
    }
  }
  for (size_t i = 0; i < h.size(); ++i) z.data()[i] = static_cast<float>(h[i]);
  return z;
}

}  // namespace seamount::erosion

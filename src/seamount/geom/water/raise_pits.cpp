#include "seamount/geom/water/raise_pits.h"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

/// Nodes of step x step cells, each with the lowest of them.
HeightField lowest_of_blocks(const HeightField& terrain, int step, const RunContext& run) {
  GridFrame frame = terrain.frame();
  frame.cell_m *= step;
  frame.width = (terrain.width() + step - 1) / step;
  frame.height = (terrain.height() + step - 1) / step;
  HeightField out(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto lowest = out.row(y);
      std::fill(lowest.begin(), lowest.end(), 1e30F);
      for (int j = y * step; j < std::min((y + 1) * step, terrain.height()); ++j) {
        const auto row = terrain.row(j);
        for (int x = 0; x < terrain.width(); ++x)
          lowest[static_cast<size_t>(x / step)] =
              std::min(lowest[static_cast<size_t>(x / step)], row[static_cast<size_t>(x)]);
      }
    }
  });
  return out;
}

struct Open {
  float height;
  int64_t cell;
  bool operator<(const Open& other) const { return height != other.height ? height > other.height : cell > other.cell; }
};

/// Blocks with a cell where `basins` is not 0.
Grid<uint8_t> any_of_blocks(const Grid<uint8_t>& basins, int step, const GridFrame& frame) {
  Grid<uint8_t> out(frame, 0);
  for (int y = 0; y < basins.height(); ++y) {
    for (int x = 0; x < basins.width(); ++x) {
      if (basins(x, y) != 0) out(x / step, y / step) = 1;
    }
  }
  return out;
}

/// Raises what cannot drain until it falls by `slope`. Returns whether anything was raised.
bool flood_up(HeightField& terrain, float sea, float slope, const Grid<uint8_t>& basins) {
  const int width = terrain.width(), height = terrain.height();
  std::priority_queue<Open> open;
  Grid<uint8_t> seen(terrain.frame(), 0);
  const auto is_land = [&](int x, int y) { return terrain(x, y) > sea && (basins.empty() || basins(x, y) == 0); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!is_land(x, y)) {
        seen(x, y) = 1;
        continue;
      }
      bool shore = x == 0 || y == 0 || x + 1 == width || y + 1 == height;
      for (size_t k = 0; k < 8 && !shore; ++k) shore = !is_land(x + kFlowDx[k], y + kFlowDy[k]);
      if (!shore) continue;
      seen(x, y) = 1;
      open.push({terrain(x, y), static_cast<int64_t>(y) * width + x});
    }
  }
  bool raised = false;
  const float step = slope * static_cast<float>(terrain.cell_m());
  while (!open.empty()) {
    const Open at = open.top();
    open.pop();
    const auto x = static_cast<int>(at.cell % width), y = static_cast<int>(at.cell / width);
    for (size_t k = 0; k < 8; ++k) {
      const int nx = x + kFlowDx[k], ny = y + kFlowDy[k];
      if (nx < 0 || ny < 0 || nx >= width || ny >= height || seen(nx, ny) != 0) continue;
      seen(nx, ny) = 1;
      const float least = at.height + step * kFlowLength[k];
      float& z = terrain(nx, ny);
      raised = raised || z < least;
      z = std::max(z, least);
      open.push({z, static_cast<int64_t>(ny) * width + nx});
    }
  }
  return raised;
}

}  // namespace

void raise_pits(HeightField& terrain, float sea_level_m, double slope, int side, const Grid<uint8_t>& basins,
                const RunContext& run) {
  const int step = std::max(1, (std::max(terrain.width(), terrain.height()) + side - 1) / side);
  const HeightField before = lowest_of_blocks(terrain, step, run);
  ScalarField lift = before;
  const Grid<uint8_t> drains = basins.empty() ? Grid<uint8_t>() : any_of_blocks(basins, step, lift.frame());
  if (!flood_up(lift, sea_level_m, static_cast<float>(slope), drains)) return;
  for (size_t c = 0; c < lift.size(); ++c) lift.cells()[c] -= before.cells()[c];
  const GridFrame& frame = terrain.frame();
  std::vector<uint8_t> lifted(static_cast<size_t>(lift.height()), 0);
  for (int y = 0; y < lift.height(); ++y)
    lifted[static_cast<size_t>(y)] = std::any_of(lift.row(y).begin(), lift.row(y).end(), [](float l) { return l > 0; });
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    RowUpsampler rows(lift);
    std::vector<float> added(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      const int near = y / step;  // the interpolation reads two rows on both sides
      const auto first = lifted.begin() + std::max(0, near - 2);
      if (std::none_of(first, lifted.begin() + std::min(lift.height(), near + 3), [](uint8_t l) { return l != 0; }))
        continue;
      rows.read(frame.x(0), frame.cell_m, frame.y(y), added);
      const auto heights = terrain.row(y);
      for (size_t x = 0; x < added.size(); ++x)
        heights[x] += heights[x] > sea_level_m ? std::max(0.0F, added[x]) : 0.0F;
    }
  });
}

}  // namespace seamount::geom

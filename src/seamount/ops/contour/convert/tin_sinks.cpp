#include "seamount/ops/contour/convert/tin_sinks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "seamount/geom/tin/node_graph.h"
#include "seamount/geom/tin/tin_border.h"
#include "seamount/geom/tin/tin_raster.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// The sinks that one comes to going down from the low nodes.
std::vector<int64_t> sinks_below(const std::vector<int32_t>& nodes, const Tin& tin, const HeightField& heights,
                                 const RunContext& run) {
  std::vector<int64_t> sinks;
  for (const int32_t node : nodes) {
    run.check_cancelled();
    const Vec2 p = tin.nodes[at(node)];
    int x = static_cast<int>(std::lround(std::clamp(heights.frame().column(p.x), 0.0, heights.width() - 1.0)));
    int y = static_cast<int>(std::lround(std::clamp(heights.frame().row(p.y), 0.0, heights.height() - 1.0)));
    for (bool down = true; down;) {
      down = false;
      const int x0 = x;
      const int y0 = y;
      for (int ny = y0 - 1; ny <= y0 + 1; ++ny) {
        for (int nx = x0 - 1; nx <= x0 + 1; ++nx) {
          if (!heights.contains(nx, ny) || heights(nx, ny) >= heights(x, y)) continue;
          x = nx;
          y = ny;
          down = true;
        }
      }
    }
    sinks.push_back(static_cast<int64_t>(y) * heights.width() + x);
  }
  return sinks;
}

/// Per node a number of the hollow that it lies in, under water if the hollow were full; -1: in none.
std::vector<int32_t> find_hollows(const Tin& tin, const RunContext& run) {
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size(), run);
  using Open = std::pair<float, int32_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  std::vector<float> level(tin.nodes.size(), NAN);
  for (const std::vector<int32_t>& ring : geom::border_rings(tin, run)) {
    for (const int32_t node : ring) {
      level[at(node)] = tin.height_m[at(node)];
      open.emplace(level[at(node)], node);
    }
  }
  std::vector<int32_t> hollow(tin.nodes.size(), -1);
  int32_t count = 0;
  for (size_t taken = 0; !open.empty(); ++taken) {
    if (taken % 16384 == 0) run.check_cancelled();
    const auto [z, node] = open.top();
    open.pop();
    int32_t here = hollow[at(node)];
    for (const int32_t neighbour : graph.around(at(node))) {
      if (!std::isnan(level[at(neighbour)])) continue;
      level[at(neighbour)] = std::max(z, tin.height_m[at(neighbour)]);
      open.emplace(level[at(neighbour)], neighbour);
      if (tin.height_m[at(neighbour)] >= z) continue;
      if (here < 0) here = count++;
      hollow[at(neighbour)] = here;
    }
  }
  return hollow;
}

/// The lowest cell of each hollow: of the centres in triangles with a node in it, all other nodes of which are higher
/// than its water.
std::vector<int64_t> lowest_cells(const std::vector<int32_t>& hollow, const Tin& tin, const HeightField& heights,
                                  const RunContext& run) {
  const int32_t count = hollow.empty() ? 0 : *std::max_element(hollow.begin(), hollow.end()) + 1;
  std::vector<int64_t> lowest(at(count), -1);
  const GridFrame& frame = heights.frame();
  size_t done = 0;
  for (const std::array<int32_t, 3>& t : tin.triangles) {
    if (++done % 65536 == 0) run.check_cancelled();
    const int32_t in = std::max({hollow[at(t[0])], hollow[at(t[1])], hollow[at(t[2])]});
    if (in < 0) continue;
    std::array<Vec2, 3> p;
    for (size_t k = 0; k < 3; ++k) p[k] = {frame.column(tin.nodes[at(t[k])].x), -frame.row(tin.nodes[at(t[k])].y)};
    const auto [west, east] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [south, north] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (int y = static_cast<int>(std::max(std::ceil(-north), 0.0)); y <= -south && y < frame.height; ++y) {
      for (int x = static_cast<int>(std::max(std::ceil(west), 0.0)); x <= east && x < frame.width; ++x) {
        const Vec2 c = {static_cast<double>(x), -static_cast<double>(y)};
        const auto left_of = [&](size_t k) { return cross(p[(k + 1) % 3] - p[k], c - p[k]) >= 0.0; };
        if (!left_of(0) || !left_of(1) || !left_of(2)) continue;
        int64_t& best = lowest[at(in)];
        const int64_t cell = static_cast<int64_t>(y) * frame.width + x;
        if (best < 0 || heights(x, y) < heights.cells()[static_cast<size_t>(best)]) best = cell;
      }
    }
  }
  std::erase(lowest, -1);
  return lowest;
}

}  // namespace

std::vector<int64_t> sinks_of(const Tin& tin, const HeightField& heights, const RunContext& run) {
  const std::vector<int32_t> low = geom::find_low_nodes(tin, run);
  if (low.empty()) return {};
  std::vector<int64_t> sinks = sinks_below(low, tin, heights, run);
  for (const int64_t cell : lowest_cells(find_hollows(tin, run), tin, heights, run)) sinks.push_back(cell);
  std::sort(sinks.begin(), sinks.end());
  sinks.erase(std::unique(sinks.begin(), sinks.end()), sinks.end());
  return sinks;
}

}  // namespace seamount::contour

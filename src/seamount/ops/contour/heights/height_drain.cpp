// Water's way down a grown network (node_heights.h).
//
// Growth gave every node a neighbour of lower rank or below its region; heights follow ranks only as far as outlines
// and rivers let them. The lowest such neighbour is a node's drain. Ranks order the drains before the nodes, so that
// one pass from the top lowers every drain below what it drains, as far as limits allow, and one from the bottom lifts
// the rest.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "seamount/geom/scalar/bucket_sort.h"
#include "seamount/ops/contour/growth/region_graph.h"
#include "seamount/ops/contour/heights/node_heights.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// A dam is cut to this share of the height above its band's lowest: a slope that water runs down.
constexpr double kCut = 0.999;

int32_t find_drain(const Tin& tin, const geom::NodeGraph& graph, const std::vector<double>& height, size_t node) {
  const int32_t here = tin.region[node];
  int32_t lowest = -1;
  for (const int32_t neighbour : graph.around(node)) {
    const int32_t there = tin.region[at(neighbour)];
    const bool lower = here == there ? std::pair(tin.rank[at(neighbour)], neighbour) <
                                           std::pair(tin.rank[node], static_cast<int32_t>(node))
                                     : border_of(tin.regions, here, there).side == Side::lower;
    if (!lower) continue;
    if (there == Tin::kOutside) return -1;
    if (lowest < 0 || height[at(neighbour)] < height[at(lowest)]) lowest = neighbour;
  }
  return lowest;
}

template <class Heights>
bool has_lower(const Heights& height, const geom::NodeGraph& graph, int32_t node) {
  const auto around = graph.around(at(node));
  return std::any_of(around.begin(), around.end(), [&](int32_t n) { return height[at(n)] < height[at(node)]; });
}

}  // namespace

std::vector<uint8_t> edge_nodes(const Tin& tin, const geom::NodeGraph& graph) {
  std::vector<uint32_t> triangles(tin.nodes.size(), 0);
  for (const auto& triangle : tin.triangles) {
    for (const int32_t corner : triangle) ++triangles[at(corner)];
  }
  std::vector<uint8_t> edge(tin.nodes.size());
  for (size_t node = 0; node < edge.size(); ++node) edge[node] = triangles[node] != graph.around(node).size() ? 1 : 0;
  return edge;
}

std::vector<int32_t> rank_order(const Tin& tin, const std::vector<RegionBand>& bands, const RunContext& run) {
  struct Key {
    int level;
    float rank;
    int32_t node;
  };
  std::vector<Key> keys;
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (tin.region[node] < 0) continue;
    keys.push_back({bands[at(tin.region[node])].level, tin.rank[node], static_cast<int32_t>(node)});
  }
  int low = 0, high = 0;
  for (const RegionBand& band : bands) low = std::min(low, band.level), high = std::max(high, band.level);
  run.check_cancelled();
  geom::bucket_sort(
      keys, [&](const Key& key) { return (key.level - low + static_cast<double>(key.rank)) / (high - low + 1); },
      [](const Key& a, const Key& b) { return std::tie(a.level, a.rank, a.node) < std::tie(b.level, b.rank, b.node); });
  std::vector<int32_t> order;
  order.reserve(keys.size());
  for (const Key& key : keys) order.push_back(key.node);
  return order;
}

std::vector<int32_t> find_drains(const Tin& tin, const geom::NodeGraph& graph, const std::vector<double>& height,
                                 const RunContext& run) {
  std::vector<int32_t> drains(tin.nodes.size(), -1);
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (node % 16384 == 0) run.check_cancelled();
    if (tin.region[node] >= 0) drains[node] = find_drain(tin, graph, height, node);
  }
  return drains;
}

std::vector<float> drain(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                         const Limits& limits, std::vector<double> height, const RunContext& run) {
  const std::vector<int32_t> order = rank_order(tin, bands, run);
  const std::vector<int32_t> drains = find_drains(tin, graph, height, run);
  const std::vector<uint8_t> edge = edge_nodes(tin, graph);
  for (auto node = order.rbegin(); node != order.rend(); ++node) {
    const int32_t to = drains[at(*node)];
    if (to < 0 || height[at(to)] < height[at(*node)]) continue;
    if (edge[at(*node)] != 0 || has_lower(height, graph, *node)) continue;
    const double base = bands[at(tin.region[at(to)])].from_m;
    const double cut = base + kCut * (height[at(*node)] - base);
    height[at(to)] = std::max(limits.floor[at(to)], std::min(cut, height[at(*node)]));
  }
  run.check_cancelled();
  std::vector<float> result(height.begin(), height.end());
  constexpr float kFar = std::numeric_limits<float>::infinity();
  for (const int32_t node : order) {  // rounded, but not over an outline's height
    float& z = result[at(node)];
    if (static_cast<double>(z) > limits.cap[at(node)]) z = std::nextafter(z, -kFar);
    if (static_cast<double>(z) < limits.floor[at(node)]) z = std::nextafter(z, kFar);
  }
  run.check_cancelled();
  for (const int32_t node : order) {
    const int32_t to = drains[at(node)];
    if (to < 0 || result[at(to)] < result[at(node)]) continue;
    if (edge[at(node)] != 0 || has_lower(result, graph, node)) continue;
    result[at(node)] = std::nextafter(result[at(to)], kFar);
  }
  return result;
}

void fill_pits(Tin& tin, const geom::NodeGraph& graph, const RunContext& run) {
  std::vector<uint8_t> done = edge_nodes(tin, graph);
  bool any = false;
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (node % 16384 == 0) run.check_cancelled();
    const int32_t r = tin.region[node];
    if (r < 0 || tin.regions[at(r)].basin) done[node] = 1;
    any = any || (done[node] == 0 && !has_lower(tin.height_m, graph, static_cast<int32_t>(node)));
  }
  if (!any) return;
  using Place = std::pair<float, int32_t>;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> front;
  for (size_t node = 0; node < done.size(); ++node) {
    if (node % 16384 == 0) run.check_cancelled();
    if (done[node] != 0) front.emplace(tin.height_m[node], static_cast<int32_t>(node));
  }
  for (size_t taken = 1; !front.empty(); ++taken) {
    if (taken % 16384 == 0) run.check_cancelled();
    const auto [height, node] = front.top();
    front.pop();
    for (const int32_t neighbour : graph.around(at(node))) {
      if (done[at(neighbour)] != 0) continue;
      done[at(neighbour)] = 1;
      float& z = tin.height_m[at(neighbour)];
      z = std::max(z, std::nextafter(height, std::numeric_limits<float>::max()));
      front.emplace(z, neighbour);
    }
  }
}

}  // namespace seamount::contour

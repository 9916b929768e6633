// Water's way down a grown network (node_heights.h).
//
// Growth gave every node a neighbour of lower rank or below its region; heights follow ranks only as far as outlines
// and rivers let them. The lowest such neighbour is a node's drain. Ranks order the drains before the nodes, so that
// one pass from the top lowers every drain below what it drains, as far as limits allow, and one from the bottom lifts
// the rest.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

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

}  // namespace

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
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    run.check_cancelled();
    return std::tie(a.level, a.rank, a.node) < std::tie(b.level, b.rank, b.node);
  });
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
  for (auto node = order.rbegin(); node != order.rend(); ++node) {
    const int32_t to = drains[at(*node)];
    if (to < 0 || height[at(to)] < height[at(*node)]) continue;
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
    result[at(node)] = std::nextafter(result[at(to)], kFar);
  }
  return result;
}

}  // namespace seamount::contour

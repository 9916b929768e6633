#include "seamount/ops/contour/growth/region_graph.h"

#include <algorithm>

#include "seamount/base/rng.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

struct Edge {
  int32_t from, to;
  auto operator<=>(const Edge&) const = default;
};

/// Nodes at the edge of the network. Around every other node the triangles close: the ends of the edges that leave it
/// are the starts of those that reach it, so that sums of their hashes agree.
std::vector<uint8_t> find_rim(std::span<const std::array<int32_t, 3>> triangles, size_t nodes) {
  std::vector<uint64_t> sums(nodes, 0);
  const auto hash = [](int32_t i) { return mix_bits(static_cast<uint64_t>(i) + 1); };
  for (const auto& [a, b, c] : triangles) {
    const uint64_t ha = hash(a), hb = hash(b), hc = hash(c);
    sums[at(a)] += hb - hc;
    sums[at(b)] += hc - ha;
    sums[at(c)] += ha - hb;
  }
  std::vector<uint8_t> rim(nodes);
  for (size_t i = 0; i < nodes; ++i) rim[i] = sums[i] != 0 ? 1 : 0;
  return rim;
}

/// Edges at the edge of the network, turned around: those that no triangle has.
std::vector<Edge> missing_edges(std::span<const std::array<int32_t, 3>> triangles, const std::vector<uint8_t>& rim) {
  std::vector<Edge> edges;
  for (const std::array<int32_t, 3>& t : triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const Edge edge{t[k], t[(k + 1) % 3]};
      if (rim[at(edge.from)] != 0 && rim[at(edge.to)] != 0) edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> missing;
  for (const Edge edge : edges) {
    const Edge turned{edge.to, edge.from};
    if (!std::binary_search(edges.begin(), edges.end(), turned)) missing.push_back(turned);
  }
  return missing;
}

void group_by_region(std::span<const int32_t> region, size_t regions, RegionGraph& graph) {
  graph.firsts.assign(regions + 1, 0);
  for (const int32_t r : region) {
    if (r >= 0) ++graph.firsts[at(r) + 1];
  }
  for (size_t r = 0; r < regions; ++r) graph.firsts[r + 1] += graph.firsts[r];
  graph.nodes.resize(graph.firsts.back());
  std::vector<uint32_t> next(graph.firsts.begin(), graph.firsts.end() - 1);
  for (size_t i = 0; i < region.size(); ++i) {
    if (region[i] >= 0) graph.nodes[next[at(region[i])]++] = static_cast<int32_t>(i);
  }
}

}  // namespace

BorderNode border_of(const std::vector<TinRegion>& regions, int32_t here, int32_t there) {
  for (int32_t child = there; child >= 0; child = regions[at(child)].parent) {
    if (regions[at(child)].parent != here) continue;
    return {0, child, regions[at(child)].basin ? Side::lower : Side::upper};
  }
  if (regions[at(here)].basin) return {0, -1, Side::upper};
  for (int32_t around = regions[at(here)].parent; there >= 0 && around != there; around = regions[at(around)].parent) {
    if (around < 0) return {0, -1, Side::across};
  }
  return {0, -1, Side::lower};
}

RegionGraph make_region_graph(std::span<const std::array<int32_t, 3>> triangles, std::span<const int32_t> region,
                              const std::vector<TinRegion>& regions, const RunContext& run) {
  RegionGraph graph;
  graph.borders.resize(regions.size());
  group_by_region(region, regions.size(), graph);
  run.check_cancelled();
  const std::vector<uint8_t> rim = find_rim(triangles, region.size());
  run.check_cancelled();
  const std::vector<Edge> missing = missing_edges(triangles, rim);
  run.check_cancelled();
  for (size_t i = 0; i < rim.size(); ++i) {
    if (rim[i] != 0 && region[i] >= 0) graph.rim.push_back(static_cast<int32_t>(i));
  }

  const auto for_each_edge = [&](auto&& visit) {
    size_t done = 0;
    for (const auto& [a, b, c] : triangles) {
      if (++done % 65536 == 0) run.check_cancelled();
      visit(a, b);
      visit(b, c);
      visit(c, a);
    }
    for (const Edge& edge : missing) visit(edge.from, edge.to);
  };
  graph.starts.assign(region.size() + 2, 0);  // one slot ahead, so that filling leaves the starts in place
  for_each_edge([&](int32_t from, int32_t to) {
    const int32_t here = region[at(from)], there = region[at(to)];
    if (here < 0) return;
    if (here == there) {
      ++graph.starts[at(from) + 2];
    } else {
      BorderNode border = border_of(regions, here, there);
      border.node = from;
      graph.borders[at(here)].push_back(border);
    }
  });
  run.check_cancelled();
  for (size_t i = 2; i < graph.starts.size(); ++i) graph.starts[i] += graph.starts[i - 1];
  graph.neighbours.resize(graph.starts.back());
  for_each_edge([&](int32_t from, int32_t to) {
    if (region[at(from)] < 0 || region[at(from)] != region[at(to)]) return;
    graph.neighbours[graph.starts[at(from) + 1]++] = to;
  });
  graph.starts.pop_back();
  for (std::vector<BorderNode>& border : graph.borders) {
    run.check_cancelled();
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
  }
  return graph;
}

}  // namespace seamount::contour

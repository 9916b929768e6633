#include "seamount/geom/tin/node_graph.h"

#include <algorithm>

namespace seamount::geom {

NodeGraph make_node_graph(std::span<const std::array<int32_t, 3>> triangles, size_t nodes, const RunContext& run) {
  std::vector<uint32_t> starts(nodes + 1, 0);
  for (const std::array<int32_t, 3>& t : triangles) {
    for (const int32_t node : t) starts[static_cast<size_t>(node) + 1] += 2;
  }
  for (size_t i = 0; i < nodes; ++i) starts[i + 1] += starts[i];
  run.check_cancelled();
  std::vector<int32_t> twice(starts.back());  // most sides belong to two triangles
  std::vector<uint32_t> next(starts.begin(), starts.end() - 1);
  size_t done = 0;
  for (const auto& [a, b, c] : triangles) {
    if (++done % 65536 == 0) run.check_cancelled();
    const auto add = [&](int32_t from, int32_t to) { twice[next[static_cast<size_t>(from)]++] = to; };
    add(a, b), add(a, c), add(b, a), add(b, c), add(c, a), add(c, b);
  }
  NodeGraph graph;
  graph.starts.assign(1, 0);
  graph.starts.reserve(nodes + 1);
  graph.neighbours.reserve(twice.size() / 2 + twice.size() / 16);
  for (size_t i = 0; i < nodes; ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    const auto first = twice.begin() + starts[i];
    const auto last = twice.begin() + starts[i + 1];
    std::sort(first, last);
    graph.neighbours.insert(graph.neighbours.end(), first, std::unique(first, last));
    graph.starts.push_back(static_cast<uint32_t>(graph.neighbours.size()));
  }
  return graph;
}

}  // namespace seamount::geom

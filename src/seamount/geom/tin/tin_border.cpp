// Around a node inside, each neighbour follows one triangle's corner and precedes another's, so hashes of neighbours,
// added as followers and subtracted as predecessors, cancel. They do not on the border. That finds its nodes in one
// pass, and only edges between them need to be matched.
#include "seamount/geom/tin/tin_border.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "seamount/base/rng.h"
#include "seamount/geom/polygon/predicates.h"

namespace seamount::geom {
namespace {

using Edge = std::pair<int32_t, int32_t>;  ///< from, to

std::vector<char> border_nodes(const Tin& tin) {
  std::vector<uint64_t> sums(tin.nodes.size(), 0);
  for (const std::array<int32_t, 3>& t : tin.triangles) {
    const std::array<uint64_t, 3> hash = {mix_bits(static_cast<uint64_t>(t[0]) + 1),
                                          mix_bits(static_cast<uint64_t>(t[1]) + 1),
                                          mix_bits(static_cast<uint64_t>(t[2]) + 1)};
    for (size_t i = 0; i < 3; ++i) sums[static_cast<size_t>(t[i])] += hash[(i + 1) % 3] - hash[(i + 2) % 3];
  }
  std::vector<char> on_border(sums.size());
  std::transform(sums.begin(), sums.end(), on_border.begin(), [](uint64_t sum) { return sum != 0 ? 1 : 0; });
  return on_border;
}

/// Edges without a twin, sorted.
std::vector<Edge> border_edges(const Tin& tin, const RunContext& run) {
  const std::vector<char> on_border = border_nodes(tin);
  run.check_cancelled();
  std::vector<Edge> edges;
  for (const std::array<int32_t, 3>& t : tin.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const Edge edge{t[i], t[(i + 1) % 3]};
      if (on_border[static_cast<size_t>(edge.first)] != 0 && on_border[static_cast<size_t>(edge.second)] != 0)
        edges.push_back(edge);
    }
  }
  run.check_cancelled();
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> alone;
  for (const Edge& edge : edges) {
    if (!std::binary_search(edges.begin(), edges.end(), Edge{edge.second, edge.first})) alone.push_back(edge);
  }
  return alone;
}

/// Whether b comes before c on the way round a node counter-clockwise from a. Exact.
bool turns_first(Vec2 node, Vec2 a, Vec2 b, Vec2 c) {
  const auto half = [&](Vec2 p) { return orientation_sign(node, a, p) > 0 || turns_back(a, node, p) ? 0 : 1; };
  return half(b) != half(c) ? half(b) < half(c) : orientation_sign(node, b, c) > 0;
}

}  // namespace

std::vector<std::vector<int32_t>> border_rings(const Tin& tin, const RunContext& run) {
  const std::vector<Edge> edges = border_edges(tin, run);
  std::vector<char> used(edges.size(), 0);
  const auto place = [&](int32_t node) { return tin.nodes[static_cast<size_t>(node)]; };
  // The next edge of a ring leaves where the gap beside the network ends.
  const auto follow = [&](const Edge& edge) {
    const Vec2 node = place(edge.second), from = place(edge.first);
    size_t best = edges.size();
    const auto first = std::lower_bound(edges.begin(), edges.end(), Edge{edge.second, 0});
    for (auto next = first; next != edges.end() && next->first == edge.second; ++next) {
      const auto i = static_cast<size_t>(next - edges.begin());
      const auto to = [&](size_t e) { return place(edges[e].second); };
      if (used[i] == 0 && (best == edges.size() || turns_first(node, from, to(i), to(best)))) best = i;
    }
    return best;
  };
  std::vector<std::vector<int32_t>> rings;
  for (size_t start = 0; start < edges.size(); ++start) {
    std::vector<int32_t> ring;
    for (size_t at = start; at < edges.size() && used[at] == 0; at = follow(edges[at])) {
      used[at] = 1;
      ring.push_back(edges[at].first);
      if (edges[at].second == ring.front()) break;
    }
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  return rings;
}

namespace {

/// Nodes that the border passes more than once, ascending.
std::vector<int32_t> pinched_nodes(const Tin& tin, const RunContext& run) {
  std::vector<int32_t> passed;
  for (const std::vector<int32_t>& ring : border_rings(tin, run)) passed.insert(passed.end(), ring.begin(), ring.end());
  std::sort(passed.begin(), passed.end());
  std::vector<int32_t> pinched;
  for (size_t i = 1; i < passed.size(); ++i) {
    if (passed[i] == passed[i - 1] && (pinched.empty() || pinched.back() != passed[i])) pinched.push_back(passed[i]);
  }
  return pinched;
}

/// Of the triangles about a node, those that no chain of shared edges joins to the largest such chain.
std::vector<size_t> smaller_fans(const Tin& tin, int32_t node, const std::vector<size_t>& about) {
  std::vector<size_t> fan(about.size());  // the first triangle of each one's chain
  std::iota(fan.begin(), fan.end(), size_t{0});
  const auto others = [&](size_t t) {
    const std::array<int32_t, 3>& corners = tin.triangles[about[t]];
    const size_t k = static_cast<size_t>(std::find(corners.begin(), corners.end(), node) - corners.begin());
    return Edge{corners[(k + 1) % 3], corners[(k + 2) % 3]};
  };
  for (size_t a = 0; a < about.size(); ++a) {
    for (size_t b = 0; b < about.size(); ++b) {
      if (others(a).second != others(b).first || fan[a] == fan[b]) continue;
      const size_t low = std::min(fan[a], fan[b]), high = std::max(fan[a], fan[b]);
      std::replace(fan.begin(), fan.end(), high, low);
    }
  }
  size_t best = 0;
  for (const size_t f : fan) {
    if (std::count(fan.begin(), fan.end(), f) > std::count(fan.begin(), fan.end(), best)) best = f;
  }
  std::vector<size_t> rest;
  for (size_t t = 0; t < about.size(); ++t) {
    if (fan[t] != best) rest.push_back(about[t]);
  }
  return rest;
}

}  // namespace

void open_pinches(Tin& tin, const RunContext& run) {
  for (std::vector<int32_t> pinched = pinched_nodes(tin, run); !pinched.empty(); pinched = pinched_nodes(tin, run)) {
    std::vector<std::vector<size_t>> about(pinched.size());
    for (size_t i = 0; i < tin.triangles.size(); ++i) {
      if (i % 65536 == 0) run.check_cancelled();
      for (const int32_t node : tin.triangles[i]) {
        const auto found = std::lower_bound(pinched.begin(), pinched.end(), node);
        if (found != pinched.end() && *found == node) about[static_cast<size_t>(found - pinched.begin())].push_back(i);
      }
    }
    std::vector<char> gone(tin.triangles.size(), 0);
    for (size_t p = 0; p < pinched.size(); ++p) {
      for (const size_t i : smaller_fans(tin, pinched[p], about[p])) gone[i] = 1;
    }
    size_t kept = 0;
    for (size_t i = 0; i < gone.size(); ++i) {
      if (gone[i] == 0) tin.triangles[kept++] = tin.triangles[i];
    }
    if (kept == gone.size()) return;
    tin.triangles.resize(kept);
  }
}

}  // namespace seamount::geom

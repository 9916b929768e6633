// A ring's westernmost point looks west: the first edge that it sees belongs to the ring around it or to a ring beside
// it, whose parent is then its own too. Rings are taken from west to east, so that parent is known by then.
#include "seamount/geom/contour/nesting.h"

#include <algorithm>
#include <numeric>

#include "seamount/geom/polygon/edge_grid.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

std::vector<RingEdge> all_edges(const std::vector<Contour>& contours, const RunContext& run) {
  size_t count = 0;
  for (const Contour& contour : contours) count += contour.ring.size();
  std::vector<RingEdge> edges;
  edges.reserve(count);
  for (size_t i = 0; i < contours.size(); ++i) {
    run.check_cancelled();
    add_ring_edges(contours[i].ring, i, edges);
  }
  return edges;
}

bool further_west(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

}  // namespace

std::optional<ContourCrossing> find_contour_crossing(const std::vector<Contour>& contours, const RunContext& run) {
  const std::vector<RingEdge> edges = all_edges(contours, run);
  const EdgeGrid grid(edges, run);
  const auto meeting = grid.find_meeting([&](const RingEdge&, const RingEdge&) {
    run.check_cancelled();
    return true;
  });
  if (!meeting) return std::nullopt;
  const RingEdge& e = edges[std::min(meeting->first, meeting->second)];
  const RingEdge& f = edges[std::max(meeting->first, meeting->second)];
  return ContourCrossing{e.ring, f.ring, e.index, f.index, meeting->at};
}

std::vector<int> find_contour_parents(const std::vector<Contour>& contours, const RunContext& run) {
  const std::vector<RingEdge> edges = all_edges(contours, run);
  const EdgeGrid grid(edges, run);
  std::vector<int> parents(contours.size(), -1);
  std::vector<Vec2> tips;
  std::vector<char> hill;
  for (const Contour& contour : contours) {
    run.check_cancelled();
    tips.push_back(*std::min_element(contour.ring.begin(), contour.ring.end(), further_west));
    hill.push_back(is_hill(contour) ? 1 : 0);
  }
  std::vector<size_t> order(contours.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return further_west(tips[a], tips[b]); });
  for (const size_t ring : order) {
    run.check_cancelled();
    const auto seen = grid.first_to_the_west(tips[ring], [&](const RingEdge& edge) { return edge.ring != ring; });
    if (!seen) continue;
    const RingEdge& edge = edges[*seen];
    // The inside lies east of an edge that leads south, if its ring runs counter-clockwise.
    const bool encloses = (edge.b.y < edge.a.y) == (hill[edge.ring] != 0);
    parents[ring] = encloses ? static_cast<int>(edge.ring) : parents[edge.ring];
  }
  return parents;
}

void nest_contours(std::vector<Contour>& contours, const RunContext& run) {
  const std::vector<int> parents = find_contour_parents(contours, run);
  const size_t n = contours.size();
  std::vector<std::vector<size_t>> children(n + 1);  // the last: those without parent
  for (size_t i = 0; i < n; ++i) children[parents[i] < 0 ? n : static_cast<size_t>(parents[i])].push_back(i);
  std::vector<Contour> sorted;
  sorted.reserve(n);
  std::vector<int> place(n, -1);
  std::vector<size_t> waiting(children[n].rbegin(), children[n].rend());
  while (!waiting.empty()) {
    const size_t i = waiting.back();
    waiting.pop_back();
    place[i] = static_cast<int>(sorted.size());
    sorted.push_back(std::move(contours[i]));
    sorted.back().parent = parents[i] < 0 ? -1 : place[static_cast<size_t>(parents[i])];
    waiting.insert(waiting.end(), children[i].rbegin(), children[i].rend());
  }
  contours = std::move(sorted);
}

void orient_contours(std::vector<Contour>& contours) {
  std::vector<char> hill(contours.size(), 1);
  for (size_t i = 0; i < contours.size(); ++i) {
    Contour& contour = contours[i];
    if (contour.parent >= 0) {
      const auto parent = static_cast<size_t>(contour.parent);
      const double rise = contour.height_m - contours[parent].height_m;
      hill[i] = rise > 0.0 || (rise == 0.0 && hill[parent] == 0) ? 1 : 0;
    }
    if (is_hill(contour) != (hill[i] != 0)) std::reverse(contour.ring.begin(), contour.ring.end());
  }
}

bool is_hill(const Contour& contour) { return signed_area(contour.ring) > 0.0; }

}  // namespace seamount::geom

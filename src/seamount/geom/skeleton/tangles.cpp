// See tangles.h.
#include "seamount/geom/skeleton/tangles.h"

#include <limits>

#include "seamount/geom/polygon/edge_grid.h"

namespace seamount::geom {
namespace {

constexpr int kRounds = 4;

}  // namespace

std::vector<std::pair<size_t, size_t>> find_tangles(std::span<const Vec2> points, bool closed) {
  std::vector<RingEdge> edges;
  edges.reserve(points.size());
  for (size_t i = 0; i + 1 < points.size() + (closed ? 1 : 0); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    if (!(a == b)) edges.push_back({a, b, 0, i, edges.size() + 1});
  }
  if (!edges.empty()) edges.back().next = closed ? 0 : std::numeric_limits<size_t>::max();
  std::vector<std::pair<size_t, size_t>> tangles;
  const EdgeGrid grid(edges);
  grid.for_each_meeting([](const RingEdge&, const RingEdge&) { return true; },
                        [&](const EdgeGrid::Meeting& meeting) {
                          tangles.emplace_back(edges[meeting.first].index, edges[meeting.second].index);
                          return true;
                        });
  return tangles;
}

bool undo_tangles(std::span<const Vec2> before, std::span<Vec2> after, bool closed, std::vector<char>& moved) {
  const size_t n = after.size();
  for (int round = 0; round < kRounds; ++round) {
    const auto tangles = find_tangles(after, closed);
    if (tangles.empty()) return true;
    bool helped = false;
    const auto take_back = [&](size_t edge) {
      for (const size_t i : {edge, (edge + 1) % n}) {
        helped = helped || moved[i];
        moved[i] = 0;
        after[i] = before[i];
      }
    };
    for (const auto& [first, second] : tangles) {
      take_back(first);
      take_back(second);
    }
    if (!helped) return false;
  }
  return find_tangles(after, closed).empty();
}

}  // namespace seamount::geom

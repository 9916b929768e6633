#include "seamount/ops/contour/move/local_nesting.h"

#include <algorithm>
#include <cstdint>

#include "seamount/geom/polygon/edge_grid.h"

namespace seamount::contour {
namespace {

using geom::Box;
using geom::RingEdge;

bool holds(const Box& box, Vec2 p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

/// The edges of the runs. Neighbours know each other; an edge whose neighbour is not there has none.
void add_edges(const MovedContour& moved, size_t number, std::vector<RingEdge>& edges) {
  const Ring& ring = *moved.ring;
  const size_t first = edges.size();
  for (const auto& [begin, end] : moved.edges) {
    bool joined = false;  // to the edge that was entered last
    for (size_t j = begin; j < end; ++j) {
      const Vec2 a = ring[j];
      const Vec2 b = ring[j + 1 < ring.size() ? j + 1 : 0];
      if (a == b) continue;
      if (joined) edges.back().next = edges.size();
      edges.push_back({a, b, number, j, SIZE_MAX});
      joined = true;
    }
  }
  if (edges.size() > first && edges.back().b == edges[first].a) edges.back().next = first;
}

/// Does a contour that moved wholly lie in its parent, and in none of its siblings?
bool lies_in_its_place(const std::vector<Contour>& contours, const std::vector<Box>& boxes,
                       const std::vector<const Ring*>& rings, size_t contour) {
  const Vec2 p = (*rings[contour])[0];
  const int parent = contours[contour].parent;
  if (parent >= 0 && !geom::contains(*rings[static_cast<size_t>(parent)], p)) return false;
  for (size_t i = 0; i < contours.size(); ++i) {
    if (i == contour || contours[i].parent != parent || !holds(boxes[i], p)) continue;
    if (geom::contains(*rings[i], p)) return false;
  }
  return true;
}

}  // namespace

std::vector<NestingDefect> find_nesting_defects(const std::vector<Contour>& contours, const std::vector<Box>& boxes,
                                                const std::vector<MovedContour>& moved, const RunContext& run) {
  std::vector<RingEdge> edges;
  size_t count = 0;
  for (const MovedContour& one : moved)
    for (const auto& [begin, end] : one.edges) count += end - begin;
  edges.reserve(count);
  for (size_t i = 0; i < moved.size(); ++i) add_edges(moved[i], i, edges);
  run.check_cancelled();
  const geom::EdgeGrid grid(edges, run);
  std::vector<NestingDefect> defects;
  const auto any = [&](const RingEdge&, const RingEdge&) {
    run.check_cancelled();
    return true;
  };
  grid.for_each_meeting(any, [&](const geom::EdgeGrid::Meeting& meeting) {
    const RingEdge& e = edges[meeting.first];
    const RingEdge& f = edges[meeting.second];
    defects.push_back({meeting.at, e.ring, f.ring, e.index, f.index});
    return true;
  });
  if (!defects.empty()) return defects;
  std::vector<const Ring*> rings;
  rings.reserve(contours.size());
  for (const Contour& contour : contours) rings.push_back(&contour.ring);
  std::vector<Box> now = boxes;
  for (const MovedContour& one : moved) {
    rings[one.contour] = one.ring;
    now[one.contour] = geom::bounding_box(*one.ring);
  }
  for (size_t i = 0; i < moved.size(); ++i) {
    run.check_cancelled();
    if (moved[i].wholly && !lies_in_its_place(contours, now, rings, moved[i].contour))
      defects.push_back({(*moved[i].ring)[0], i, i, 0, 0});
  }
  return defects;
}

}  // namespace seamount::contour

#include "seamount/geom/contour/simplify.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/edge_grid.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/segment.h"

namespace seamount::geom {
namespace {

/// The points of a ring that are kept, ascending, at least three.
using Kept = std::vector<size_t>;

/// The point strictly between two of a ring's that lies furthest from the line between them, and its squared distance;
/// `to` itself if there is none. `to` may count on beyond the ring's end.
struct Furthest {
  size_t point;
  double squared;
};
Furthest furthest_between(const Ring& ring, size_t from, size_t to) {
  Furthest best{to, -1.0};
  const size_t n = ring.size();
  for (size_t i = from + 1; i < to; ++i) {
    const double d = squared_distance_to_segment(ring[i % n], ring[from % n], ring[to % n]);
    if (d > best.squared) best = {i, d};
  }
  return best;
}

/// Douglas-Peucker between two kept points; appends what it keeps, ascending, without the ends.
void keep_between(const Ring& ring, size_t from, size_t to, double squared_tolerance, Kept& kept) {
  std::vector<std::pair<size_t, size_t>> waiting = {{from, to}};
  while (!waiting.empty()) {
    const auto [a, b] = waiting.back();
    waiting.pop_back();
    const Furthest found = furthest_between(ring, a, b);
    if (found.squared > squared_tolerance) {
      waiting.push_back({found.point, b});
      waiting.push_back({a, found.point});
    } else if (b != to) {
      kept.push_back(b % ring.size());
    }
  }
}

Kept keep(const Ring& ring, double squared_tolerance) {
  const auto [low, high] =
      std::minmax_element(ring.begin(), ring.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto first = static_cast<size_t>(std::min(low, high) - ring.begin());
  const auto second = static_cast<size_t>(std::max(low, high) - ring.begin());
  Kept kept = {first};
  keep_between(ring, first, second, squared_tolerance, kept);
  kept.push_back(second);
  keep_between(ring, second, first + ring.size(), squared_tolerance, kept);
  if (kept.size() < 3) {
    const Furthest there = furthest_between(ring, first, second);
    const Furthest back = furthest_between(ring, second, first + ring.size());
    kept.push_back((there.squared > back.squared ? there : back).point % ring.size());
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

/// Contours of which only some points are kept.
class Simplified {
 public:
  Simplified(const std::vector<Contour>& contours, double tolerance_m, const RunContext& run)
      : contours_(contours),
        parents_(find_contour_parents(contours, run)),
        squared_tolerance_(tolerance_m * tolerance_m),
        run_(run) {
    for (const Contour& contour : contours) {
      run.check_cancelled();
      kept_.push_back(keep(contour.ring, squared_tolerance_));
    }
  }

  std::vector<Contour> made() const {
    std::vector<Contour> fewer;
    for (size_t r = 0; r < contours_.size(); ++r) {
      fewer.push_back({contours_[r].height_m, {}, contours_[r].parent});
      for (const size_t i : kept_[r]) fewer.back().ring.push_back(contours_[r].ring[i]);
    }
    return fewer;
  }

  /// Gives the edges that meet others their furthest points back; false if none do.
  bool split_meeting_edges() {
    const std::vector<Contour> fewer = made();
    std::vector<RingEdge> edges;
    for (size_t r = 0; r < fewer.size(); ++r) add_ring_edges(fewer[r].ring, r, edges);
    std::vector<std::pair<size_t, size_t>> wanted;  // ring, edge
    const auto any = [this](const RingEdge&, const RingEdge&) {
      run_.check_cancelled();
      return true;
    };
    EdgeGrid(edges, run_).for_each_meeting(any, [&](const EdgeGrid::Meeting& meeting) {
      for (const size_t number : {meeting.first, meeting.second})
        wanted.push_back({edges[number].ring, edges[number].index});
      return true;
    });
    return split(std::move(wanted));
  }

  /// The same for edges that have passed over a whole contour. REQUIRES: none meet.
  bool split_passing_edges() {
    const std::vector<Contour> fewer = made();
    const std::vector<int> parents = find_contour_parents(fewer, run_);
    std::vector<std::pair<size_t, size_t>> wanted;
    for (size_t r = 0; r < parents.size(); ++r) {
      if (parents[r] == parents_[r]) continue;
      const Vec2 inside = fewer[r].ring.front();
      for (const int ring : {static_cast<int>(r), parents[r], parents_[r]}) {
        if (ring >= 0) add_edges_over(static_cast<size_t>(ring), inside, wanted);
      }
    }
    return split(std::move(wanted));
  }

 private:
  /// Where the edge after kept point `edge` ends; counts on beyond the ring's end.
  size_t end_of(size_t ring, size_t edge) const {
    const Kept& points = kept_[ring];
    return edge + 1 < points.size() ? points[edge + 1] : points.front() + contours_[ring].ring.size();
  }

  /// Edges for which points all around p were dropped.
  void add_edges_over(size_t ring, Vec2 p, std::vector<std::pair<size_t, size_t>>& wanted) const {
    const Ring& points = contours_[ring].ring;
    for (size_t e = 0; e < kept_[ring].size(); ++e) {
      Ring dropped;
      for (size_t i = kept_[ring][e]; i <= end_of(ring, e); ++i) dropped.push_back(points[i % points.size()]);
      const Box box = bounding_box(dropped);
      const bool over = p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
      if (dropped.size() > 2 && over) wanted.push_back({ring, e});
    }
  }

  bool split(std::vector<std::pair<size_t, size_t>> wanted) {
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    std::vector<Kept> back(kept_.size());
    for (const auto& [ring, edge] : wanted) {
      const Ring& points = contours_[ring].ring;
      const size_t from = kept_[ring][edge];
      const size_t to = end_of(ring, edge);
      const size_t point = furthest_between(points, from, to).point;
      if (point == to) continue;
      keep_between(points, from, point, squared_tolerance_, back[ring]);
      back[ring].push_back(point % points.size());
      keep_between(points, point, to, squared_tolerance_, back[ring]);
    }
    bool any = false;
    for (size_t ring = 0; ring < back.size(); ++ring) {
      any = any || !back[ring].empty();
      kept_[ring].insert(kept_[ring].end(), back[ring].begin(), back[ring].end());
      std::sort(kept_[ring].begin(), kept_[ring].end());
    }
    return any;
  }

  const std::vector<Contour>& contours_;
  std::vector<int> parents_;
  double squared_tolerance_;
  const RunContext& run_;
  std::vector<Kept> kept_;
};

}  // namespace

void simplify_contours(std::vector<Contour>& contours, double tolerance_m, const RunContext& run) {
  Simplified simplified(contours, tolerance_m, run);
  do {
    do run.check_cancelled();
    while (simplified.split_meeting_edges());
  } while (simplified.split_passing_edges());
  contours = simplified.made();
}

}  // namespace seamount::geom

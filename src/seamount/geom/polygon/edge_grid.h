// Edges of rings in a square grid of about as many cells as edges, so that what meets an edge, or lies beside a place,
// is found among a handful. For the checks of polygon.h and contour/nesting.h. What it decides is exact (predicates.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/polygon/predicates.h"

namespace seamount::geom {

struct RingEdge {
  Vec2 a, b;           ///< different places
  size_t ring, index;  ///< the edge leaves point `index` of ring `ring`
  size_t next;         ///< number of the edge after it in its ring
};

/// Appends the edges of a ring; those of no length are left out.
void add_ring_edges(const Ring& ring, size_t number, std::vector<RingEdge>& edges);

class EdgeGrid {
 public:
  struct Meeting {
    size_t first, second;  ///< numbers of edges
    Vec2 at;
  };

  /// REQUIRES: finite coordinates; `edges` outlives the grid. Linear in the edges unless many span the whole.
  explicit EdgeGrid(const std::vector<RingEdge>& edges, const RunContext& run = {});

  /// The first pair of edges that cross or touch, cell by cell, of those wanted(edge, edge) allows. Neighbours in a
  /// ring meet only where one runs back over the other.
  template <class Wanted>
  std::optional<Meeting> find_meeting(Wanted&& wanted) const {
    std::optional<Meeting> found;
    for_each_meeting(wanted, [&](const Meeting& meeting) {
      found = meeting;
      return false;
    });
    return found;
  }

  /// Calls visit(meeting) for each such pair until it returns false; a pair that shares several cells comes once for
  /// each.
  template <class Wanted, class Visit>
  void for_each_meeting(Wanted&& wanted, Visit&& visit) const {
    for (size_t cell = 0; cell + 1 < starts_.size(); ++cell) {
      for (size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        for (size_t j = i + 1; j < starts_[cell + 1]; ++j) {
          const size_t first = members_[i];
          const size_t second = members_[j];
          if (!wanted(edges_[first], edges_[second])) continue;
          if (const std::optional<Vec2> at = meet(first, second)) {
            if (!visit(Meeting{first, second, *at})) return;
          }
        }
      }
    }
  }

  /// Distance from p to the nearest edge, `most` if none is nearer. Looks at the cells within `most` of p.
  double distance(Vec2 p, double most) const;

  /// The edge that a ray from p towards the west meets first, of those wanted(edge) allows. Edges hold their lower end
  /// and not their upper one, as if the ray lay a hair further north; an edge through p counts. REQUIRES: no two of
  /// them cross or touch, but for ends shared by neighbours.
  template <class Wanted>
  std::optional<size_t> first_to_the_west(Vec2 p, Wanted&& wanted) const {
    if (members_.empty()) return std::nullopt;
    const size_t row = static_cast<size_t>(cell_of(p.y - low_.y)) * static_cast<size_t>(side_);
    std::optional<size_t> best;
    for (int column = cell_of(p.x - low_.x); column >= 0; --column) {
      const size_t cell = row + static_cast<size_t>(column);
      for (size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const RingEdge& edge = edges_[members_[i]];
        if (!(std::min(edge.a.y, edge.b.y) <= p.y && p.y < std::max(edge.a.y, edge.b.y)) || !wanted(edge)) continue;
        if (lies_west_of(p, edge) || (best && !lies_east(edge, edges_[*best]))) continue;
        best = members_[i];
      }
      if (best && x_at(edges_[*best], p.y) > low_.x + (column + 2.0 * kSlack) / scale_) break;
    }
    return best;
  }

 private:
  /// By how much of a cell edges are held beyond their own, so that rounding hides no meeting.
  static constexpr double kSlack = 1e-6;

  std::optional<Vec2> meet(size_t first, size_t second) const;
  static bool lies_west_of(Vec2 p, const RingEdge& edge);
  static bool lies_east(const RingEdge& edge, const RingEdge& other);
  static double x_at(const RingEdge& edge, double y);
  int cell_of(double offset) const { return static_cast<int>(std::clamp(offset * scale_, 0.0, side_ - 1.0)); }
  template <class Visit>
  void for_each_cell(const RingEdge& edge, Visit&& visit) const;

  const std::vector<RingEdge>& edges_;
  Vec2 low_;
  int side_ = 1;
  double scale_ = 1.0;
  std::vector<size_t> starts_;
  std::vector<size_t> members_;
};

}  // namespace seamount::geom

#include "seamount/geom/polygon/frame_clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

/// The frame's edge, counter-clockwise from its south-western corner.
class Edge {
 public:
  explicit Edge(const GridFrame& frame)
      : low_{frame.west_m, frame.south_m()}, high_{frame.east_m(), frame.north_m}, size_(high_ - low_) {}

  double length() const { return 2.0 * (size_.x + size_.y); }
  bool holds(Vec2 p) const { return p.x > low_.x && p.x < high_.x && p.y > low_.y && p.y < high_.y; }
  Vec2 middle() const { return low_ + 0.5 * size_; }

  /// Of a place on it.
  double arc(Vec2 p) const {
    const std::array<double, 4> off = {std::abs(p.y - low_.y), std::abs(p.x - high_.x), std::abs(p.y - high_.y),
                                       std::abs(p.x - low_.x)};
    switch (std::min_element(off.begin(), off.end()) - off.begin()) {
      case 0:
        return p.x - low_.x;
      case 1:
        return size_.x + (p.y - low_.y);
      case 2:
        return size_.x + size_.y + (high_.x - p.x);
      default:
        return 2.0 * size_.x + size_.y + (high_.y - p.y);
    }
  }

  /// The place at an arc in [0, 2 length), `out` metres off it.
  Vec2 place(double arc, double out) const {
    arc = arc >= length() ? arc - length() : arc;
    if (arc < size_.x) return {low_.x + arc, low_.y - out};
    if (arc < size_.x + size_.y) return {high_.x + out, low_.y + (arc - size_.x)};
    if (arc < 2.0 * size_.x + size_.y) return {high_.x - (arc - size_.x - size_.y), high_.y + out};
    return {low_.x - out, high_.y - (arc - 2.0 * size_.x - size_.y)};
  }

  /// Arcs and places of the corners, `out` metres off.
  std::array<std::pair<double, Vec2>, 4> corners(double out) const {
    return {{{0.0, {low_.x - out, low_.y - out}},
             {size_.x, {high_.x + out, low_.y - out}},
             {size_.x + size_.y, {high_.x + out, high_.y + out}},
             {2.0 * size_.x + size_.y, {low_.x - out, high_.y + out}}}};
  }

  /// Shares of the way from a to b between which it lies inside; empty where from >= to.
  std::pair<double, double> inside(Vec2 a, Vec2 b) const {
    double from = 0.0, to = 1.0;
    clip(a.x, b.x, low_.x, high_.x, from, to);
    clip(a.y, b.y, low_.y, high_.y, from, to);
    return {from, to};
  }

  /// Moves a place that lies near the edge onto it.
  Vec2 snapped(Vec2 p) const { return place(std::clamp(arc(p), 0.0, length()), 0.0); }

 private:
  static void clip(double a, double b, double low, double high, double& from, double& to) {
    if (a == b) {
      if (a <= low || a >= high) to = -1.0;
      return;
    }
    const double at_low = (low - a) / (b - a), at_high = (high - a) / (b - a);
    from = std::max(from, std::min(at_low, at_high));
    to = std::min(to, std::max(at_low, at_high));
  }

  Vec2 low_, high_, size_;
};

/// A run of a ring within the frame, from the edge to the edge.
struct Piece {
  Polyline points;
  double enters = 0.0, leaves = 0.0;  ///< arcs
  size_t next = 0;                    ///< the piece that its closing leads to
};

/// Runs within the frame of a ring of which some point lies outside.
std::vector<Piece> pieces_of(const Ring& ring, const Edge& edge) {
  const size_t n = ring.size();
  const auto outside = std::find_if(ring.begin(), ring.end(), [&](Vec2 p) { return !edge.holds(p); });
  const auto first = static_cast<size_t>(outside - ring.begin());
  std::vector<Piece> pieces;
  bool open = false;
  for (size_t k = 0; k < n; ++k) {
    const Vec2 a = ring[(first + k) % n], b = ring[(first + k + 1) % n];
    const auto [from, to] = edge.inside(a, b);
    if (!open && from >= to) continue;
    if (!open) {
      pieces.emplace_back();
      pieces.back().points.push_back(edge.snapped(a + from * (b - a)));
      open = true;
    }
    if (edge.holds(b)) {
      pieces.back().points.push_back(b);
    } else {
      pieces.back().points.push_back(edge.snapped(a + std::max(to, 0.0) * (b - a)));
      open = false;
    }
  }
  for (Piece& piece : pieces) {
    piece.enters = edge.arc(piece.points.front());
    piece.leaves = edge.arc(piece.points.back());
  }
  return pieces;
}

double way(const Edge& edge, double from, double to) { return to >= from ? to - from : to - from + edge.length(); }

/// Each piece leads on to the next one that enters, counter-clockwise. In the ring's order where that does not fit.
void link(std::vector<Piece>& pieces, const Edge& edge) {
  std::vector<char> taken(pieces.size(), 0);
  bool fits = true;
  for (Piece& piece : pieces) {
    size_t best = 0;
    for (size_t i = 1; i < pieces.size(); ++i) {
      if (way(edge, piece.leaves, pieces[i].enters) < way(edge, piece.leaves, pieces[best].enters)) best = i;
    }
    piece.next = best;
    fits = fits && taken[best] == 0;
    taken[best] = 1;
  }
  for (size_t i = 0; !fits && i < pieces.size(); ++i) pieces[i].next = (i + 1) % pieces.size();
}

/// A ring on its way: counter-clockwise.
struct Working {
  Ring whole;                 ///< if it lies within the frame
  std::vector<Piece> pieces;  ///< else
  double around = 0.0;        ///< area, if it encloses the frame
  bool reversed = false;
};

Working prepare(const Ring& given, const Edge& edge) {
  Working working;
  Ring ring = given;
  working.reversed = signed_area(ring) < 0.0;
  if (working.reversed) std::reverse(ring.begin(), ring.end());
  if (std::all_of(ring.begin(), ring.end(), [&](Vec2 p) { return edge.holds(p); })) {
    working.whole = std::move(ring);
    return working;
  }
  working.pieces = pieces_of(ring, edge);
  link(working.pieces, edge);
  if (working.pieces.empty() && contains(ring, edge.middle())) working.around = signed_area(ring);
  return working;
}

/// A stretch of the edge that a closing spans, or all of it.
struct Stretch {
  double length;
  size_t ring, piece;
  auto operator<=>(const Stretch&) const = default;
};

void add_closing(const Edge& edge, const Piece& piece, double to, double out, Ring& ring) {
  constexpr double kNothing = 1e-12;
  const double length = way(edge, piece.leaves, to);
  if (length <= kNothing * edge.length()) return;
  ring.push_back(edge.place(piece.leaves, out));
  for (const double turn : {0.0, edge.length()}) {
    for (const auto& [arc, corner] : edge.corners(out)) {
      if (arc + turn > piece.leaves && arc + turn < piece.leaves + length) ring.push_back(corner);
    }
  }
  ring.push_back(edge.place(to, out));
}

void push_ring(size_t of, bool reversed, Ring ring, std::vector<ClippedRing>& closed) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return;
  if (reversed) std::reverse(ring.begin(), ring.end());
  closed.push_back({of, std::move(ring)});
}

}  // namespace

std::vector<ClippedRing> clip_to_frame(std::span<const Ring> rings, const GridFrame& frame, double reach_m) {
  const Edge edge(frame);
  std::vector<Working> all;
  std::vector<Stretch> stretches;
  for (size_t i = 0; i < rings.size(); ++i) {
    all.push_back(prepare(rings[i], edge));
    const std::vector<Piece>& pieces = all[i].pieces;
    for (size_t k = 0; k < pieces.size(); ++k)
      stretches.push_back({way(edge, pieces[k].leaves, pieces[pieces[k].next].enters), i, k});
    if (all[i].around > 0.0) stretches.push_back({edge.length() + all[i].around, i, 0});
  }
  std::sort(stretches.begin(), stretches.end());
  std::vector<std::vector<double>> out(rings.size());
  for (size_t i = 0; i < rings.size(); ++i) out[i].resize(std::max<size_t>(all[i].pieces.size(), 1));
  for (size_t rank = 0; rank < stretches.size(); ++rank) {
    const Stretch& stretch = stretches[rank];
    out[stretch.ring][stretch.piece] = reach_m * static_cast<double>(rank + 1) / static_cast<double>(stretches.size());
  }
  std::vector<ClippedRing> closed;
  for (size_t i = 0; i < rings.size(); ++i) {
    Working& working = all[i];
    if (!working.whole.empty()) push_ring(i, working.reversed, std::move(working.whole), closed);
    if (working.around > 0.0) {
      Ring ring;
      for (const auto& [arc, corner] : edge.corners(out[i][0])) ring.push_back(corner);
      push_ring(i, working.reversed, std::move(ring), closed);
    }
    std::vector<char> done(working.pieces.size(), 0);
    for (size_t first = 0; first < done.size(); ++first) {
      Ring ring;
      for (size_t k = first; done[k] == 0; k = working.pieces[k].next) {
        done[k] = 1;
        const Piece& piece = working.pieces[k];
        ring.insert(ring.end(), piece.points.begin(), piece.points.end());
        add_closing(edge, piece, working.pieces[piece.next].enters, out[i][k], ring);
      }
      if (!ring.empty()) push_ring(i, working.reversed, std::move(ring), closed);
    }
  }
  return closed;
}

std::vector<FrameRun> runs_in_frame(const Ring& ring, const GridFrame& frame) {
  const Edge edge(frame);
  if (ring.empty()) return {};
  if (std::all_of(ring.begin(), ring.end(), [&](Vec2 p) { return edge.holds(p); })) return {{ring, true}};
  std::vector<FrameRun> runs;
  for (Piece& piece : pieces_of(ring, edge)) {
    Polyline& points = piece.points;
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() >= 2) runs.push_back({std::move(points), false});
  }
  return runs;
}

}  // namespace seamount::geom

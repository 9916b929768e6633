#include "seamount/geom/tin/delaunay_builder.h"

#include <utility>

namespace seamount::geom {
namespace {

constexpr int32_t kGhost = -1;  ///< the vertex at infinity

constexpr int32_t next_edge(int32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
constexpr int32_t previous_edge(int32_t e) { return e % 3 == 0 ? e + 2 : e - 1; }

}  // namespace

// Half edge e = 3 t + k runs from corner k of triangle t to the next one; twin_[e] is the same edge of the triangle on
// its other side. Each hull edge has a ghost triangle outside, whose third corner is kGhost.

template <int kBits>
DelaunayBuilder<kBits>::DelaunayBuilder(std::vector<LatticePoint> points) : points_(std::move(points)) {
  corner_.reserve(6 * points_.size());
  twin_.reserve(6 * points_.size());
}

template <int kBits>
int32_t DelaunayBuilder<kBits>::add(LatticePoint point) {
  points_.push_back(point);
  return static_cast<int32_t>(points_.size()) - 1;
}

template <int kBits>
bool DelaunayBuilder<kBits>::start(std::span<const int32_t> order) {
  const auto point = [&](size_t i) { return points_[at(order[i])]; };
  size_t b = 1;
  while (b < order.size() && point(b) == point(0)) ++b;
  size_t c = b + 1;
  while (c < order.size() && orientation(point(0), point(b), point(c)) == 0) ++c;
  if (c >= order.size()) return false;
  Triangle abc = {order[0], order[b], order[c]};
  if (orientation(point(0), point(b), point(c)) < 0) std::swap(abc[1], abc[2]);
  corner_ = {abc[0], abc[1], abc[2], abc[1], abc[0], kGhost, abc[2], abc[1], kGhost, abc[0], abc[2], kGhost};
  twin_.resize(corner_.size());
  join(0, 3);
  join(1, 6);
  join(2, 9);
  join(4, 11);
  join(5, 7);
  join(8, 10);
  return true;
}

template <int kBits>
std::span<const int32_t> DelaunayBuilder<kBits>::insert(int32_t p) {
  return insert(p, locate(points_[at(p)]));
}

// Triangles whose circle holds p are replaced by a fan around p.
template <int kBits>
std::span<const int32_t> DelaunayBuilder<kBits>::insert(int32_t p, int32_t triangle) {
  if (is_corner(triangle, points_[at(p)])) return {};
  dig(triangle, points_[at(p)]);
  fill(p);
  return dead_;
}

template <int kBits>
int32_t DelaunayBuilder<kBits>::to(int32_t e) const {
  return corner_[at(next_edge(e))];
}

template <int kBits>
void DelaunayBuilder<kBits>::join(int32_t e, int32_t f) {
  twin_[at(e)] = f;
  twin_[at(f)] = e;
}

/// Corner of a ghost triangle that is at infinity, 3 for others.
template <int kBits>
int DelaunayBuilder<kBits>::ghost_corner(int32_t t) const {
  for (int k = 0; k < 3; ++k) {
    if (corner_[at(3 * t + k)] == kGhost) return k;
  }
  return 3;
}

template <int kBits>
bool DelaunayBuilder<kBits>::is_corner(int32_t t, LatticePoint p) const {
  for (int32_t e = 3 * t; e < 3 * t + 3; ++e) {
    if (from(e) != kGhost && points_[at(from(e))] == p) return true;
  }
  return false;
}

/// Is p inside the circle of triangle t? For a ghost: beyond its hull edge, or on the edge itself.
template <int kBits>
bool DelaunayBuilder<kBits>::conflicts(int32_t t, LatticePoint p) const {
  const int32_t a = corner_[at(3 * t)], b = corner_[at(3 * t + 1)], c = corner_[at(3 * t + 2)];
  if ((a | b | c) >= 0) return in_circle<kBits>(points_[at(a)], points_[at(b)], points_[at(c)], p);
  const int32_t opposite = 3 * t + (ghost_corner(t) + 1) % 3;
  const LatticePoint u = points_[at(from(opposite))], v = points_[at(to(opposite))];
  const int64_t side = orientation(u, v, p);
  if (side != 0) return side > 0;
  return p != u && p != v && (u < v ? u < p && p < v : v < p && p < u);
}

/// A triangle that holds p, or the ghost of a hull edge that p lies beyond. Walks over edges that have p on their far
/// side, which never turns in circles on a Delaunay triangulation.
template <int kBits>
int32_t DelaunayBuilder<kBits>::locate(LatticePoint p) const {
  int32_t t = last_;
  for (int32_t entered = -1;;) {
    int32_t out = -1;
    for (int32_t e = 3 * t; e < 3 * t + 3 && out < 0; ++e) {
      if (e != entered && orientation(points_[at(from(e))], points_[at(to(e))], p) < 0) out = e;
    }
    if (out < 0) return t;
    entered = twin_[at(out)];
    t = entered / 3;
    if (ghost_corner(t) < 3) return t;
  }
}

/// Collects the triangles in conflict, of which `seed` is one, into dead_, and the edges around them, as the living
/// triangles see them, counter-clockwise into rim_.
template <int kBits>
void DelaunayBuilder<kBits>::dig(int32_t seed, LatticePoint p) {
  dead_.assign(1, seed);
  rim_.clear();
  stack_ = {twin_[at(3 * seed + 2)], twin_[at(3 * seed + 1)], twin_[at(3 * seed)]};
  while (!stack_.empty()) {
    const int32_t e = stack_.back();
    stack_.pop_back();
    if (conflicts(e / 3, p)) {
      dead_.push_back(e / 3);
      stack_.push_back(twin_[at(previous_edge(e))]);
      stack_.push_back(twin_[at(next_edge(e))]);
    } else {
      rim_.push_back(e);
    }
  }
}

/// Joins every edge of the rim to p. There are two more triangles than died.
template <int kBits>
void DelaunayBuilder<kBits>::fill(int32_t p) {
  const size_t size = corner_.size();
  dead_.push_back(static_cast<int32_t>(size / 3));
  dead_.push_back(static_cast<int32_t>(size / 3 + 1));
  corner_.resize(size + 6);
  twin_.resize(size + 6);
  int32_t previous = 3 * dead_[rim_.size() - 1] + 1;
  for (size_t i = 0; i < rim_.size(); ++i) {
    const int32_t t = dead_[i], outer = rim_[i];
    const int32_t a = to(outer), b = from(outer);
    corner_[at(3 * t)] = a;
    corner_[at(3 * t + 1)] = b;
    corner_[at(3 * t + 2)] = p;
    join(3 * t, outer);
    join(3 * t + 2, previous);
    previous = 3 * t + 1;
    if ((a | b) >= 0) last_ = t;
  }
}

template class DelaunayBuilder<14>;
template class DelaunayBuilder<kLatticeBits>;

}  // namespace seamount::geom

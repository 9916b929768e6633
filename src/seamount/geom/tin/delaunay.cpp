#include "seamount/geom/tin/delaunay.h"

#include <algorithm>
#include <bit>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

constexpr int32_t kGhost = -1;  ///< the vertex at infinity

constexpr int32_t next_edge(int32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
constexpr int32_t previous_edge(int32_t e) { return e % 3 == 0 ? e + 2 : e - 1; }

/// Half edge e = 3 t + k runs from corner k of triangle t to the next one; twin_[e] is the same edge of the triangle on
/// its other side. Each hull edge has a ghost triangle outside, whose third corner is kGhost.
class Builder {
 public:
  explicit Builder(std::span<const LatticePoint> points) : points_(points) {
    corner_.reserve(6 * points.size());
    twin_.reserve(6 * points.size());
  }

  /// REQUIRES: a, b, c run counter-clockwise.
  void start(int32_t a, int32_t b, int32_t c) {
    corner_ = {a, b, c, b, a, kGhost, c, b, kGhost, a, c, kGhost};
    twin_.resize(corner_.size());
    join(0, 3);
    join(1, 6);
    join(2, 9);
    join(4, 11);
    join(5, 7);
    join(8, 10);
  }

  /// Adds point p unless there is one in its place. Triangles whose circle holds p are replaced by a fan around p.
  void insert(int32_t p) {
    const int32_t found = locate(points_[at(p)]);
    if (is_corner(found, points_[at(p)])) return;
    dig(found, points_[at(p)]);
    fill(p);
  }

  std::vector<Triangle> triangles(const RunContext& run) const;

 private:
  static size_t at(int32_t i) { return static_cast<size_t>(i); }
  int32_t from(int32_t e) const { return corner_[at(e)]; }
  int32_t to(int32_t e) const { return corner_[at(next_edge(e))]; }

  void join(int32_t e, int32_t f) {
    twin_[at(e)] = f;
    twin_[at(f)] = e;
  }

  /// Corner of a ghost triangle that is at infinity, 3 for others.
  int ghost_corner(int32_t t) const {
    for (int k = 0; k < 3; ++k) {
      if (corner_[at(3 * t + k)] == kGhost) return k;
    }
    return 3;
  }

  bool is_corner(int32_t t, LatticePoint p) const {
    for (int32_t e = 3 * t; e < 3 * t + 3; ++e) {
      if (from(e) != kGhost && points_[at(from(e))] == p) return true;
    }
    return false;
  }

  /// Is p inside the circle of triangle t? For a ghost: beyond its hull edge, or on the edge itself.
  bool conflicts(int32_t t, LatticePoint p) const {
    const int32_t a = corner_[at(3 * t)], b = corner_[at(3 * t + 1)], c = corner_[at(3 * t + 2)];
    if ((a | b | c) >= 0) return in_circle(points_[at(a)], points_[at(b)], points_[at(c)], p);
    const int32_t opposite = 3 * t + (ghost_corner(t) + 1) % 3;
    const LatticePoint u = points_[at(from(opposite))], v = points_[at(to(opposite))];
    const int64_t side = orientation(u, v, p);
    if (side != 0) return side > 0;
    return p != u && p != v && (u < v ? u < p && p < v : v < p && p < u);
  }

  /// A triangle that holds p, or the ghost of a hull edge that p lies beyond. Walks over edges that have p on their far
  /// side, which never turns in circles on a Delaunay triangulation.
  int32_t locate(LatticePoint p) const {
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
  void dig(int32_t seed, LatticePoint p) {
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
  void fill(int32_t p) {
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

  std::span<const LatticePoint> points_;
  std::vector<int32_t> corner_, twin_;
  std::vector<int32_t> dead_, rim_, stack_;
  int32_t last_ = 0;
};

std::vector<Triangle> Builder::triangles(const RunContext& run) const {
  std::vector<int32_t> starts(points_.size() + 1, 0);
  const auto for_each = [&](auto&& visit) {
    for (int32_t t = 0; t < static_cast<int32_t>(corner_.size() / 3); ++t) {
      if (t % 65536 == 0) run.check_cancelled();
      if (ghost_corner(t) < 3) continue;
      Triangle abc = {from(3 * t), from(3 * t + 1), from(3 * t + 2)};
      std::rotate(abc.begin(), std::min_element(abc.begin(), abc.end()), abc.end());
      visit(abc);
    }
  };
  for_each([&](const Triangle& abc) { ++starts[at(abc[0]) + 1]; });
  for (size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<Triangle> sorted(at(starts.back()));
  for_each([&](const Triangle& abc) { sorted[at(starts[at(abc[0])]++)] = abc; });
  return sorted;
}

/// The first three points along `order` that span a triangle, counter-clockwise; the rest of the work needs one.
bool first_triangle(std::span<const LatticePoint> points, const std::vector<int32_t>& order, Triangle& abc) {
  const auto point = [&](size_t i) { return points[static_cast<size_t>(order[i])]; };
  size_t b = 1;
  while (b < order.size() && point(b) == point(0)) ++b;
  size_t c = b + 1;
  while (c < order.size() && orientation(point(0), point(b), point(c)) == 0) ++c;
  if (c >= order.size()) return false;
  abc = {order[0], order[b], order[c]};
  if (orientation(point(0), point(b), point(c)) < 0) std::swap(abc[1], abc[2]);
  return true;
}

/// The points of an order in rounds, each along the order: one in four is in a later round than the first.
std::vector<std::vector<int32_t>> rounds_of(const std::vector<int32_t>& order) {
  constexpr int kRounds = 16;
  std::vector<std::vector<int32_t>> rounds(kRounds);
  for (const int32_t p : order) {
    const uint64_t bits = mix_bits(static_cast<uint64_t>(p) + 1) | (1ULL << (2 * kRounds - 1));
    rounds[static_cast<size_t>(std::countr_zero(bits) / 2)].push_back(p);
  }
  return rounds;
}

}  // namespace

std::vector<Triangle> delaunay(std::span<const LatticePoint> points, const RunContext& run) {
  constexpr size_t kPointsPerReport = 1 << 12;
  const std::vector<int32_t> order = spatial_order(points, run);
  Triangle first{};
  if (points.size() < 3 || !first_triangle(points, order, first)) return {};
  run.check_cancelled();
  Builder builder(points);
  builder.start(first[0], first[1], first[2]);
  size_t done = 0;
  const std::vector<std::vector<int32_t>> rounds = rounds_of(order);
  run.check_cancelled();
  for (size_t round = rounds.size(); round-- > 0;) {
    for (const int32_t p : rounds[round]) {
      builder.insert(p);
      if (++done % kPointsPerReport != 0) continue;
      run.check_cancelled();
      run.report(static_cast<double>(done) / static_cast<double>(points.size()));
    }
  }
  return builder.triangles(run);
}

std::vector<Triangle> delaunay(std::span<const Vec2> points, const RunContext& run) {
  std::vector<LatticePoint> snapped;
  snap(points, snapped);
  return delaunay(snapped, run);
}

}  // namespace seamount::geom

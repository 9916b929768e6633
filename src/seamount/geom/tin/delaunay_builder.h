// A Delaunay triangulation that grows: the incremental insertion of delaunay.h, for those who choose the next point by
// what the triangles are so far.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "seamount/geom/polygon/lattice_points.h"

namespace seamount::geom {

/// Corners of a triangle as indices of points, counter-clockwise.
using Triangle = std::array<int32_t, 3>;

/// Triangles have numbers that are used again for others once they are gone. Outside of each edge of the hull lies a
/// ghost: a triangle whose third corner is at infinity. Coordinates lie in [0, 2^kBits); kBits is 14 or 29.
template <int kBits>
class DelaunayBuilder {
 public:
  /// The points that insert() may be asked for; add() takes more.
  explicit DelaunayBuilder(std::vector<LatticePoint> points);

  int32_t add(LatticePoint point);
  const std::vector<LatticePoint>& points() const { return points_; }

  /// The first triangle: of the first three points along `order` that span one. False if all lie on one line. What of
  /// the order is left is for insert(), which passes over these three.
  bool start(std::span<const int32_t> order);

  /// Adds point p unless there is one in its place, and returns the triangles around it, ghosts among them: all that
  /// changed. Walks to p from where the last one was. REQUIRES: start(). The answer holds until the next call.
  std::span<const int32_t> insert(int32_t p);
  /// The same for a point whose triangle is known. REQUIRES: p lies in `triangle` or on its edge.
  std::span<const int32_t> insert(int32_t p, int32_t triangle);

  int32_t triangle_count() const { return static_cast<int32_t>(corner_.size() / 3); }  ///< ghosts among them
  bool is_ghost(int32_t t) const { return ghost_corner(t) < 3; }
  Triangle corners(int32_t t) const { return {corner_[at(3 * t)], corner_[at(3 * t + 1)], corner_[at(3 * t + 2)]}; }

 private:
  static size_t at(int32_t i) { return static_cast<size_t>(i); }
  int32_t from(int32_t e) const { return corner_[at(e)]; }
  int32_t to(int32_t e) const;
  void join(int32_t e, int32_t f);
  int ghost_corner(int32_t t) const;
  bool is_corner(int32_t t, LatticePoint p) const;
  bool conflicts(int32_t t, LatticePoint p) const;
  int32_t locate(LatticePoint p) const;
  void dig(int32_t seed, LatticePoint p);
  void fill(int32_t p);

  std::vector<LatticePoint> points_;
  std::vector<int32_t> corner_, twin_;
  std::vector<int32_t> dead_, rim_, stack_;
  int32_t last_ = 0;
};

}  // namespace seamount::geom

// The faces between contours: which cells lie in which, and which heights bound it.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Face 0 lies outside all contours, face i + 1 directly inside contour i. Its bounds are contour i and the contours
/// whose parent is i, by their different heights.
class ContourFaces {
 public:
  /// One height that bounds a face.
  struct Bound {
    int32_t face;
    double height_m;
  };

  /// REQUIRES: a nested and oriented set (model/contour_set.h). Linear.
  explicit ContourFaces(const std::vector<Contour>& contours);

  int32_t count() const { return static_cast<int32_t>(first_.size()) - 1; }
  /// All bounds, by face and then ascending; those of a face are [first_bound(face), first_bound(face + 1)).
  const std::vector<Bound>& bounds() const { return bounds_; }
  size_t first_bound(int32_t face) const { return first_[static_cast<size_t>(face)]; }
  size_t bounds_of(int32_t face) const { return first_bound(face + 1) - first_bound(face); }
  /// The lowest and highest bound. REQUIRES: it has any.
  double low_m(int32_t face) const { return bounds_[first_bound(face)].height_m; }
  double high_m(int32_t face) const { return bounds_[first_bound(face + 1) - 1].height_m; }

  /// The bound that a contour is for the face inside it and for the one around it.
  size_t inner_bound(size_t contour) const { return inner_[contour]; }
  size_t outer_bound(size_t contour) const { return outer_[contour]; }

  /// Whether the ground of a face with one bound rises from it (a summit, a rim) or falls (a basin, the land outside).
  bool rises(int32_t face) const { return rises_[static_cast<size_t>(face)] != 0; }
  /// Faces directly inside a basin that hold no further basin: where water may stay.
  bool holds_water(int32_t face) const { return holds_water_[static_cast<size_t>(face)] != 0; }

 private:
  std::vector<Bound> bounds_;
  std::vector<size_t> first_, inner_, outer_;
  std::vector<char> rises_, holds_water_;
};

/// For each cell the face in which its centre lies. REQUIRES: as ContourFaces. Parallel; linear in cells and edges.
Grid<int32_t> rasterise_faces(const std::vector<Contour>& contours, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::geom

// The sheet that contours were cut at: a ring whose border is measured by its length, and what lies at it.
#pragma once

#include <optional>
#include <vector>

#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// The border of a sheet: places on it by their way along it, counter-clockwise, and beyond it.
class SheetBorder {
 public:
  /// REQUIRES: at least three different places; about convex.
  explicit SheetBorder(Ring ring);

  double length() const { return starts_.back(); }
  double size() const { return size_; }  ///< of the longer side of its box
  const Ring& ring() const { return ring_; }

  struct Foot {
    double arc;       ///< of the nearest place
    double distance;  ///< to it
  };
  Foot nearest(Vec2 p) const;
  /// A place on the border, moved away from its middle by a share of its distance from there.
  Vec2 place(double arc, double out) const;
  /// All of it, as far out.
  Ring moved(double out) const;
  /// Appends the corners between two places, going counter-clockwise, as far out.
  void append_corners(double from, double to, double out, Ring& ring) const;

 private:
  Ring ring_;
  std::vector<double> starts_;  ///< arc of each point; the length at last
  Vec2 middle_;
  double size_ = 0.0;
};

/// The ring around all places of lines: a rectangle, or as narrow as it can be and bulges nowhere inwards.
Ring rectangle_around(const std::vector<ValuedLine>& lines);
Ring hull_around(const std::vector<ValuedLine>& lines);
Ring frame_ring(const GridFrame& frame);

/// The first of the candidates that has all ends of open lines within `tolerance` of its size at its border, else the
/// one with most. REQUIRES: at least one.
SheetBorder choose_sheet(const std::vector<Ring>& candidates, const std::vector<ValuedLine>& lines, double tolerance);

/// The largest upright frame in the sheet, of as many cells along its longer side as `wanted`; `wanted` itself where it
/// is the same within two cells.
GridFrame frame_in(const SheetBorder& sheet, const GridFrame& wanted);

}  // namespace seamount::geom

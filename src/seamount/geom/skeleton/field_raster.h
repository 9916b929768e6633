// A field sampled around a place, bilinear between its samples, with its integrals over areas: what region snakes read.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {

/// Samples at origin + (column, row) cell for columns and rows that may be negative. Grows on demand; what was sampled
/// stays what it is, and so do integrals but for rounding. REQUIRES: the first box holds the origin.
class FieldRaster {
 public:
  FieldRaster() = default;
  FieldRaster(Vec2 origin, double cell_m) : origin_(origin), cell_(cell_m) {}

  double cell_m() const { return cell_; }
  bool covers(const Box& box) const;
  /// Samples that it would have if it covered a box too.
  double size_with(const Box& box) const;
  /// Appends the places that covers(box) lacks; fill() takes what the field is there.
  void add_missing(const Box& box, std::vector<Vec2>& places);
  size_t missing() const { return wanted_; }
  void fill(std::span<const double> values);
  /// Value of unfit samples (not finite) in what follows; once, after the first fill().
  void set_floor(double floor);
  /// Mean and deviation of fit samples.
  struct Spread {
    double lowest = 0.0, mean = 0.0, deviation = 0.0;
    size_t count = 0;
  };
  Spread spread() const;

  /// REQUIRES for all: the place is covered.
  double at(Vec2 p) const;
  /// Whether all four samples around a place are fit.
  bool fit(Vec2 p) const;
  /// The integral of the field from the meridian of the origin to p along its row: what it is over an area is the
  /// integral of this by y around the outline (Green).
  double integral_to(Vec2 p) const;

 private:
  struct Cell {
    size_t index;
    double s, t;  ///< shares towards east and north
  };
  Cell cell_of(Vec2 p) const;
  void sum_rows();

  Vec2 origin_;
  double cell_ = 1.0;
  int column_ = 0, row_ = 0;  ///< of the first sample
  int width_ = 0, height_ = 0;
  std::vector<double> raw_;     ///< as the field gave it
  std::vector<double> values_;  ///< unfit ones at the floor
  std::vector<double> sums_;    ///< integral from the origin's column on
  double floor_ = 0.0;
  size_t wanted_ = 0;
  std::vector<uint32_t> wanted_at_;
};

}  // namespace seamount::geom

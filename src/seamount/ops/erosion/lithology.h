// Beds of rock in three dimensions: hardness as a function of place and height.
//
// A sequence of beds lies parallel to a datum, the top of the first bed: a plane by dip and strike (right-hand rule:
// beds dip to the right of the strike), bent by folds and broken by faults. Thicknesses are measured across the beds of
// the tilted plane; folds shift beds up and down (similar folds: as thick along the vertical everywhere). A fault's
// plane cuts the height top_m along its trace and dips to the right of it; what lies over the plane has moved by the
// throw. Faults are older than the ground: they move beds, not its surface. Everything is a function of the place, so
// that cells of any size show the same beds.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/model/grid.h"
#include "seamount/ops/erosion/lithology_params.h"

namespace seamount::erosion {

/// Beds below a datum, by depth in metres across them.
class BedSequence {
 public:
  BedSequence() = default;
  BedSequence(const std::vector<BedParams>& beds, bool repeat);

  /// A bed, and the depths that it lies between; infinite where it has no end.
  struct Bed {
    int index;
    float hardness, top, bottom;
  };

  bool empty() const { return hardness_.empty(); }
  /// The bed at a depth. At a border: the bed below it. REQUIRES: not empty.
  Bed at(float depth) const;
  /// The bed under or over another. REQUIRES: there is one: bottom, or top, is finite.
  Bed under(const Bed& bed) const;
  Bed over(const Bed& bed) const;

  size_t count() const { return hardness_.size(); }
  /// Thickness of the sequence; infinite if it does not repeat.
  float period() const { return period_; }
  /// Means over the sequence of hardness and of its inverse root.
  float mean_hardness() const { return mean_hardness_; }
  float mean_ease() const { return mean_ease_; }
  float softest() const { return softest_; }

 private:
  Bed bed_of(float cycle, size_t index) const;

  std::vector<float> hardness_, top_;  // of each bed; and at the end the thickness of all
  bool repeats_ = false;
  float period_ = 0, mean_hardness_ = 1, mean_ease_ = 1, softest_ = 1;
};

/// Where the beds lie.
class Lithology {
 public:
  /// Throws InvalidArgument: params out of range, a trace of less than two points.
  Lithology(const LithologyParams& params, Seed seed);

  const BedSequence& beds() const { return beds_; }
  /// Height of the datum in the block of rock that (x, y, z) lies in. Metres.
  double datum(double x, double y, double z) const;
  /// Metres across the beds in a metre of height.
  double stretch(double x, double y) const;
  /// Number of the bed at a place, from 0 for the first of the list, and its hardness. REQUIRES: beds().
  int bed(double x, double y, double z) const;
  double hardness(double x, double y, double z) const;

  /// By how much faults have lowered the beds at a place: part of datum().
  double thrown(double x, double y, double z) const;
  /// Does that depend on the height?
  bool faults_dip() const;
  /// The datum without faults, and stretch, along a row of a grid.
  void datum_row(const GridFrame& frame, int row, std::span<float> datum) const;
  void stretch_row(const GridFrame& frame, int row, std::span<float> stretch) const;
  bool stretch_varies() const { return params_.thickness_variation > 0; }

 private:
  double plane(double x, double y) const;
  double folded(double x, double y, double bend, double swell) const;
  double depth(double x, double y, double z) const { return (datum(x, y, z) - z) * stretch(x, y); }

  LithologyParams params_;
  BedSequence beds_;
  Seed bends_, swells_, thickness_;
};

}  // namespace seamount::erosion

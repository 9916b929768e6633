// How much ground lies at which height: the histogram that heights are taken from, as its quantiles in order.
//
// Source: P2 sec. 3.3, 4.4 (a histogram and sorted samples of it). Where we depart: quantiles instead of random samples
// (the same limit without noise), and any restriction of the histogram to a range, so that ground between two contours
// of known height follows the part of the histogram between them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::contour {

/// Distributions that look like landforms, over the whole range of heights.
enum class Landform : uint8_t { mountain, uniform, hills, plateau, coastal, volcano, canyon };

class HeightDistribution {
 public:
  /// Bins of equal width from low_m to high_m, each with how much ground lies in it. Throws InvalidArgument{field} for
  /// no bins, a bin that is negative or not finite, bins that are all zero, or low_m >= high_m.
  static HeightDistribution from_bins(const std::vector<double>& bins, double low_m, double high_m,
                                      const std::string& field);
  /// A density over the share of the range, x from 0 (low_m) to 1 (high_m), smooth between its knots. Throws like
  /// from_bins, and for fewer than two knots or knots outside [0, 1].
  static HeightDistribution from_density(const Curve& density, double low_m, double high_m, const std::string& field);
  static HeightDistribution of_landform(Landform landform, double low_m, double high_m);

  double low_m() const { return low_; }
  double high_m() const { return high_; }

  /// Share of the ground below z, in [0, 1]. Ascending and continuous.
  double share_below(double z) const;
  /// Height below which a share u of the ground between `from` and `to` lies; where the distribution has no ground
  /// there, or the two reach beyond it, evenly between. Ascends strictly with u from `from` (0) to `to` (1), heights
  /// without ground excepted, which it steps over. REQUIRES: from <= to.
  double quantile(double from, double to, double u) const;

 private:
  double low_ = 0.0;
  double high_ = 1.0;
  std::vector<double> below_;  ///< share below the edge of each bin; from 0 to 1
};

/// How much ground lies in each of `bins` bins between a terrain's lowest and highest cell.
struct MeasuredHeights {
  std::vector<double> bins;
  double low_m = 0.0;
  double high_m = 1.0;
};

/// The heights of the cells at or above `above_m`. Throws IncompatibleInputs where there are none, or only one height.
/// Linear in cells.
MeasuredHeights measure_heights(const HeightField& terrain, double above_m, int bins);

}  // namespace seamount::contour

template <>
struct seamount::Choices<seamount::contour::Landform> {
  static constexpr std::array<std::string_view, 7> names = {"mountain", "uniform", "hills", "plateau",
                                                            "coastal",  "volcano", "canyon"};
};

// How the values of a terrain's cells are distributed: moments of the values themselves, and their cumulative curve.
#pragma once

#include <cstdint>
#include <vector>

namespace seamount::hydrology {

/// Number, mean and sum of squared differences from it, of values that came in parts (Chan, Golub and LeVeque 1983).
struct Moments {
  int64_t count = 0;
  double mean = 0.0, squares = 0.0;
  double low = 0.0, high = 0.0;  ///< of the values

  void join(const Moments& other);
};

/// Moments of values as they come; about the first of them, so that squares do not cancel.
class RunningMoments {
 public:
  void add(double value) {
    if (count_++ == 0) first_ = low_ = high_ = value;
    low_ = value < low_ ? value : low_;
    high_ = value > high_ ? value : high_;
    sum_ += value - first_;
    squares_ += (value - first_) * (value - first_);
  }
  Moments moments() const;

 private:
  int64_t count_ = 0;
  double first_ = 0.0, low_ = 0.0, high_ = 0.0, sum_ = 0.0, squares_ = 0.0;
};

/// Values in bins, of which only those that hold any are kept. Without values: everything is not a number.
class Distribution {
 public:
  /// Values spread evenly over [low, high]; a place where both are equal.
  struct Bin {
    double low = 0.0, high = 0.0;
    int64_t count = 0;
  };

  Distribution() = default;
  /// REQUIRES: bins in ascending order that do not overlap, of as many values as `moments`.
  Distribution(std::vector<Bin> bins, const Moments& moments);
  /// Each value its own bin, so nothing is rounded.
  explicit Distribution(std::vector<double> values);
  /// Of log10(factor * value). REQUIRES: values above 0. Moments are those of the bins' middles.
  Distribution logarithmic(double factor) const;

  bool empty() const { return bins_.empty(); }
  int64_t count() const { return moments_.count; }
  double low() const;
  double high() const;
  double mean() const;
  double deviation() const;
  /// The value below which a share of the values lies.
  double quantile(double share) const;
  /// Share of the values below a place, and of those below or at it.
  double below(double place) const { return share(place, false); }
  double up_to(double place) const { return share(place, true); }
  /// All places where a bin begins or ends, ascending.
  std::vector<double> edges() const;

 private:
  double share(double place, bool with_place) const;

  std::vector<Bin> bins_;
  std::vector<int64_t> before_;  ///< values in the bins before each
  Moments moments_;
};

/// First Wasserstein distance of two distributions, each of total 1: the area between their cumulative curves, in the
/// unit of the values, whatever the bins of each. Not a number if one of them is empty.
double wasserstein(const Distribution& a, const Distribution& b);

}  // namespace seamount::hydrology

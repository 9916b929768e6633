#include "seamount/ops/hydrology/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamount::hydrology {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Integral of |a straight line| over a width, from its values at both ends.
double area_under(double from, double to, double width) {
  const double a = std::abs(from), b = std::abs(to);
  if ((from < 0.0) == (to < 0.0) || a == 0.0 || b == 0.0) return 0.5 * (a + b) * width;
  return 0.5 * (a * a + b * b) / (a + b) * width;
}

}  // namespace

void Moments::join(const Moments& other) {
  if (other.count == 0) return;
  if (count == 0) {
    *this = other;
    return;
  }
  const auto ours = static_cast<double>(count), theirs = static_cast<double>(other.count);
  const double step = other.mean - mean;
  mean += step * theirs / (ours + theirs);
  squares += other.squares + step * step * ours * theirs / (ours + theirs);
  count += other.count;
  low = std::min(low, other.low);
  high = std::max(high, other.high);
}

Moments RunningMoments::moments() const {
  if (count_ == 0) return {};
  const auto count = static_cast<double>(count_);
  return {count_, first_ + sum_ / count, std::max(0.0, squares_ - sum_ * sum_ / count), low_, high_};
}

Distribution::Distribution(std::vector<Bin> bins, const Moments& moments) : bins_(std::move(bins)), moments_(moments) {
  before_.reserve(bins_.size());
  int64_t before = 0;
  for (const Bin& bin : bins_) {
    before_.push_back(before);
    before += bin.count;
  }
}

Distribution::Distribution(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::vector<Bin> bins;
  RunningMoments moments;
  for (const double value : values) {
    bins.push_back({value, value, 1});
    moments.add(value);
  }
  *this = Distribution(std::move(bins), moments.moments());
}

Distribution Distribution::logarithmic(double factor) const {
  std::vector<Bin> bins = bins_;
  Moments moments;
  for (Bin& bin : bins) {
    bin.low = std::log10(factor * bin.low);
    bin.high = std::log10(factor * bin.high);
    const double middle = 0.5 * (bin.low + bin.high);
    moments.join({bin.count, middle, 0.0, middle, middle});
  }
  if (!bins.empty()) moments.low = bins.front().low, moments.high = bins.back().high;
  return {std::move(bins), moments};
}

double Distribution::low() const { return empty() ? kNaN : moments_.low; }

double Distribution::high() const { return empty() ? kNaN : moments_.high; }

double Distribution::mean() const { return empty() ? kNaN : moments_.mean; }

double Distribution::deviation() const {
  return empty() ? kNaN : std::sqrt(moments_.squares / static_cast<double>(moments_.count));
}

double Distribution::quantile(double share) const {
  if (empty()) return kNaN;
  const double wanted = share * static_cast<double>(moments_.count);
  const auto after = std::upper_bound(before_.begin() + 1, before_.end(), wanted,
                                      [](double value, int64_t before) { return value < static_cast<double>(before); });
  const auto at = static_cast<size_t>(after - before_.begin()) - 1;
  const Bin& bin = bins_[at];
  const double part = (wanted - static_cast<double>(before_[at])) / static_cast<double>(bin.count);
  return std::clamp(bin.low + part * (bin.high - bin.low), moments_.low, moments_.high);
}

std::vector<double> Distribution::edges() const {
  std::vector<double> places;
  places.reserve(2 * bins_.size());
  for (const Bin& bin : bins_) {
    if (places.empty() || bin.low > places.back()) places.push_back(bin.low);
    if (bin.high > places.back()) places.push_back(bin.high);
  }
  return places;
}

double Distribution::share(double place, bool with_place) const {
  if (empty()) return kNaN;
  // The last bin that begins before the place, or at it where that counts.
  const auto after = std::upper_bound(bins_.begin(), bins_.end(), place, [&](double value, const Bin& bin) {
    return with_place ? value < bin.low : value <= bin.low;
  });
  if (after == bins_.begin()) return 0.0;
  const auto at = static_cast<size_t>(after - bins_.begin()) - 1;
  const Bin& bin = bins_[at];
  const double part = place >= bin.high ? 1.0 : (place - bin.low) / (bin.high - bin.low);
  return (static_cast<double>(before_[at]) + part * static_cast<double>(bin.count)) /
         static_cast<double>(moments_.count);
}

double wasserstein(const Distribution& a, const Distribution& b) {
  if (a.empty() || b.empty()) return kNaN;
  const std::vector<double> ours = a.edges(), theirs = b.edges();
  std::vector<double> places(ours.size() + theirs.size());
  std::merge(ours.begin(), ours.end(), theirs.begin(), theirs.end(), places.begin());
  double area = 0.0;
  for (size_t i = 1; i < places.size(); ++i) {
    const double from = places[i - 1], to = places[i];
    if (from < to) area += area_under(a.up_to(from) - b.up_to(from), a.below(to) - b.below(to), to - from);
  }
  return area;
}

}  // namespace seamount::hydrology

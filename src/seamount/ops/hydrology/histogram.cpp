#include "seamount/ops/hydrology/histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace seamount::hydrology {
namespace {

/// Differences of the cumulative curves after each bin.
std::vector<double> cumulative_gaps(const Histogram& a, const Histogram& b) {
  const auto all_a = static_cast<double>(a.total()), all_b = static_cast<double>(b.total());
  std::vector<double> gaps;
  if (all_a == 0.0 || all_b == 0.0) return gaps;
  double gap = 0.0;
  for (size_t i = 0; i < a.counts.size(); ++i) {
    gap += static_cast<double>(a.counts[i]) / all_a - static_cast<double>(b.counts[i]) / all_b;
    gaps.push_back(gap);
  }
  return gaps;
}

}  // namespace

void Histogram::add(double value) {
  const double bin = std::floor((value - low) / width());
  const auto last = static_cast<double>(counts.size() - 1);
  ++counts[static_cast<size_t>(std::clamp(bin, 0.0, last))];
}

int64_t Histogram::total() const { return std::accumulate(counts.begin(), counts.end(), int64_t{0}); }

double Histogram::mean() const {
  double sum = 0.0;
  for (size_t i = 0; i < counts.size(); ++i) sum += static_cast<double>(counts[i]) * middle(i);
  return sum / static_cast<double>(std::max<int64_t>(1, total()));
}

double Histogram::deviation() const {
  const double centre = mean();
  double sum = 0.0;
  for (size_t i = 0; i < counts.size(); ++i)
    sum += static_cast<double>(counts[i]) * (middle(i) - centre) * (middle(i) - centre);
  return std::sqrt(sum / static_cast<double>(std::max<int64_t>(1, total())));
}

double Histogram::quantile(double share) const {
  const double wanted = share * static_cast<double>(total());
  double below = 0.0;
  for (size_t i = 0; i < counts.size(); ++i) {
    const auto here = static_cast<double>(counts[i]);
    if (here > 0.0 && below + here >= wanted) return low + (static_cast<double>(i) + (wanted - below) / here) * width();
    below += here;
  }
  return high;
}

Histogram Histogram::coarser(int bins) const {
  Histogram out(low, high, bins);
  const size_t each = counts.size() / out.counts.size();
  for (size_t i = 0; i < counts.size(); ++i) out.counts[i / each] += counts[i];
  return out;
}

double wasserstein(const Histogram& a, const Histogram& b) {
  double area = 0.0;
  for (const double gap : cumulative_gaps(a, b)) area += std::abs(gap) * a.width();
  return area;
}

double circular_wasserstein(const Histogram& a, const Histogram& b) {
  const std::vector<double> gaps = cumulative_gaps(a, b);
  if (gaps.empty()) return 0.0;
  std::vector<double> sorted = gaps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  double area = 0.0;
  for (const double gap : gaps) area += std::abs(gap - *middle) * a.width();
  return area;
}

}  // namespace seamount::hydrology

// Distributions of numbers in bins of one width, and how far two of them are apart.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/parallel.h"

namespace seamount::hydrology {

struct Histogram {
  double low = 0.0, high = 1.0;  ///< what lies beyond counts in the first and the last bin
  std::vector<int64_t> counts;

  Histogram(double first, double last, int bins) : low(first), high(last), counts(static_cast<size_t>(bins), 0) {}
  void add(double value);
  int64_t total() const;
  double width() const { return (high - low) / static_cast<double>(counts.size()); }
  double middle(size_t bin) const { return low + (static_cast<double>(bin) + 0.5) * width(); }
  double mean() const;
  double deviation() const;
  /// The value below which a share of the numbers lies, linear within bins.
  double quantile(double share) const;
  /// Merged into fewer bins. REQUIRES: bins divides the number of bins.
  Histogram coarser(int bins) const;
};

/// The values of those places [0, count) that `counts` allows, in parallel.
template <class Counts, class Value>
Histogram gather(Histogram all, int64_t count, const Counts& counts, const Value& value, const RunContext& run) {
  constexpr int64_t kGrain = int64_t{1} << 17;
  std::vector<Histogram> parts(static_cast<size_t>((count + kGrain - 1) / kGrain), all);
  parallel_blocks(run, count, kGrain, [&](int64_t begin, int64_t end) {
    Histogram& part = parts[static_cast<size_t>(begin / kGrain)];
    for (int64_t i = begin; i < end; ++i)
      if (counts(i)) part.add(value(i));
  });
  for (const Histogram& part : parts)
    for (size_t k = 0; k < all.counts.size(); ++k) all.counts[k] += part.counts[k];
  return all;
}

/// First Wasserstein distance of the two distributions, each of total 1: the area between their cumulative curves, in
/// the unit of the values. REQUIRES: the same bins. 0 if one of them is empty.
double wasserstein(const Histogram& a, const Histogram& b);

/// The same around a circle (Rabin, Delon and Gousseau 2011): the least over all places where it may be cut open.
double circular_wasserstein(const Histogram& a, const Histogram& b);

}  // namespace seamount::hydrology

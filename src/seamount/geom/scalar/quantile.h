// Order statistics: a value by its place in the order of many.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace seamount::geom {

/// The value that about `share` of the values lie below: number floor(share n) in their order, counted from 0, the last
/// at most. REQUIRES: at least one value; none is not a number; share in [0, 1]. Linear.
template <class T>
T quantile(std::vector<T> values, double share) {
  const auto rank = static_cast<size_t>(std::floor(share * static_cast<double>(values.size())));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The middle value; of an even number the upper of the two.
template <class T>
T median(std::vector<T> values) {
  return quantile(std::move(values), 0.5);
}

}  // namespace seamount::geom

// Sorting what is spread about evenly over a known range.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace seamount::geom {

/// Sorts as std::sort(items, less) does. share(item): where an item lies in the range, in [0, 1]; never less for one
/// that comes later. Linear where items spread evenly, n log n where they crowd; a copy of the items.
template <class Item, class Share, class Less>
void bucket_sort(std::vector<Item>& items, Share&& share, Less&& less) {
  const size_t n = items.size();
  if (n < 64) {
    std::sort(items.begin(), items.end(), less);
    return;
  }
  const auto bucket = [&](const Item& item) {
    const double place = share(item);  // what is not in the range crowds at its ends
    return place > 0.0 ? std::min(static_cast<size_t>(std::min(place, 1.0) * static_cast<double>(n)), n - 1) : 0;
  };
  std::vector<uint32_t> ends(n + 1, 0);
  for (const Item& item : items) ++ends[bucket(item) + 1];
  for (size_t b = 1; b <= n; ++b) ends[b] += ends[b - 1];
  std::vector<Item> sorted(n);
  for (Item& item : items) sorted[ends[bucket(item)]++] = std::move(item);
  size_t begin = 0;  // each bucket now ends where its count says
  for (size_t b = 0; b < n; ++b) {
    const size_t end = ends[b];
    if (end - begin > 1) {
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin), sorted.begin() + static_cast<std::ptrdiff_t>(end),
                less);
    }
    begin = end;
  }
  items = std::move(sorted);
}

}  // namespace seamount::geom

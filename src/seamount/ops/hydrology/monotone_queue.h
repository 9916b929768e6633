// A queue for searches whose costs never fall: a radix heap (Ahuja, Mehlhorn, Orlin and Tarjan 1990).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace seamount::hydrology {

/// Cells by key, the least first. Each entry moves through at most 64 buckets; what is emptied keeps its memory.
class MonotoneQueue {
 public:
  void clear() {
    for (std::vector<Entry>& bucket : buckets_) bucket.clear();
    least_ = 0;
    size_ = 0;
  }

  bool empty() const { return size_ == 0; }

  /// REQUIRES: key >= least().
  void push(uint64_t key, int32_t cell) {
    buckets_[bucket_of(key)].push_back({key, cell});
    ++size_;
  }

  /// Key of what was taken last.
  uint64_t least() const { return least_; }

  /// Moves all entries of the least key to `cells`, in ascending order. REQUIRES: not empty.
  void take(std::vector<int32_t>& cells) {
    if (buckets_[0].empty()) spread_first();
    cells.clear();
    for (const Entry& entry : buckets_[0]) cells.push_back(entry.cell);
    std::sort(cells.begin(), cells.end());
    size_ -= cells.size();
    buckets_[0].clear();
  }

 private:
  struct Entry {
    uint64_t key;
    int32_t cell;
  };

  /// The highest bit in which a key differs from the least decides.
  size_t bucket_of(uint64_t key) const { return 64 - static_cast<size_t>(std::countl_zero(key ^ least_)); }

  void spread_first() {
    size_t first = 1;
    while (buckets_[first].empty()) ++first;
    moving_.swap(buckets_[first]);
    least_ = moving_.front().key;
    for (const Entry& entry : moving_) least_ = std::min(least_, entry.key);
    for (const Entry& entry : moving_) buckets_[bucket_of(entry.key)].push_back(entry);
    moving_.clear();
  }

  std::array<std::vector<Entry>, 65> buckets_;
  std::vector<Entry> moving_;
  uint64_t least_ = 0;
  size_t size_ = 0;
};

}  // namespace seamount::hydrology

// A layer's result: channels last, with a row of zeros above and below, so that every band of rows has neighbours.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "seamount/model/grid.h"

namespace seamount::learned {

template <class T>
class FeatureMap {
 public:
  FeatureMap() = default;
  /// Rows [0, rows) are not initialised.
  FeatureMap(int rows, int width, int channels)
      : rows_(rows),
        width_(width),
        channels_(channels),
        stride_(static_cast<size_t>(width) * static_cast<size_t>(channels)),
        cells_(stride_ * static_cast<size_t>(rows + 2)) {
    std::fill_n(row(-1), stride_, T{});
    std::fill_n(row(rows), stride_, T{});
  }

  int rows() const { return rows_; }
  int width() const { return width_; }
  int channels() const { return channels_; }
  size_t row_size() const { return stride_; }
  /// y in [-1, rows].
  T* row(int y) { return cells_.data() + static_cast<size_t>(y + 1) * stride_; }
  const T* row(int y) const { return cells_.data() + static_cast<size_t>(y + 1) * stride_; }

 private:
  int rows_ = 0, width_ = 0, channels_ = 0;
  size_t stride_ = 0;
  std::vector<T, detail::UninitialisedAllocator<T>> cells_;
};

}  // namespace seamount::learned

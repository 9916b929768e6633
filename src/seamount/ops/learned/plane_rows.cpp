#include "seamount/ops/learned/plane_rows.h"

#include <algorithm>

namespace seamount::learned {

void PlaneRows::fetch(const Planes& planes, int width, int begin, int end) {
  first_ = std::min(begin, planes.height - 1);
  last_ = std::min(end, planes.height) - 1;
  const auto rows = static_cast<size_t>(last_ - first_ + 1), count = static_cast<size_t>(planes.count);
  const size_t given = static_cast<size_t>(planes.width) * count;
  stride_ = static_cast<size_t>(width) * count;
  if (values_.size() < rows * stride_) {
    values_.clear();
    values_.resize(rows * stride_);
  }
  // Filled at the end of the memory, then moved to where each row belongs, from the first on.
  float* packed = values_.data() + rows * (stride_ - given);
  planes.fill(first_, last_ + 1, {packed, rows * given});
  if (given == stride_) return;
  for (size_t y = 0; y < rows; ++y) {
    float* row = values_.data() + y * stride_;
    std::copy_n(packed + y * given, given, row);
    for (size_t i = given; i < stride_; ++i) row[i] = row[i - count];
  }
}

const float* PlaneRows::row(int y) const {
  return values_.data() + static_cast<size_t>(std::min(y, last_) - first_) * stride_;
}

}  // namespace seamount::learned

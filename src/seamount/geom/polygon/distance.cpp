#include "seamount/geom/polygon/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

constexpr int32_t kNone = -1;

/// Row of the nearest member of the set in each column: down, then up. Columns [begin, end).
SEAMOUNT_VECTORISED void sweep_columns(const uint8_t* inside, int32_t* nearest, int width, int height, int begin,
                                       int end) {
  for (int x = begin; x < end; ++x) nearest[x] = inside[x] != 0 ? 0 : kNone;
  for (int y = 1; y < height; ++y) {
    const uint8_t* set = inside + static_cast<int64_t>(y) * width;
    int32_t* row = nearest + static_cast<int64_t>(y) * width;
    const int32_t* above = row - width;
    for (int x = begin; x < end; ++x) row[x] = set[x] != 0 ? y : above[x];
  }
  for (int y = height - 2; y >= 0; --y) {
    int32_t* row = nearest + static_cast<int64_t>(y) * width;
    const int32_t* below = row + width;
    for (int x = begin; x < end; ++x) {
      const bool closer = below[x] >= 0 && (row[x] < 0 || below[x] - y < y - row[x]);
      row[x] = closer ? below[x] : row[x];
    }
  }
}

void find_nearest_rows(const Grid<uint8_t>& inside, int32_t* nearest, const RunContext& run) {
  parallel_blocks(run, inside.width(), 128, [&](int64_t begin, int64_t end) {
    sweep_columns(inside.data(), nearest, inside.width(), inside.height(), static_cast<int>(begin),
                  static_cast<int>(end));
  });
}

/// Lower envelope of the parabolas (x - c)^2 + (y - row[c])^2 along one row.
class Envelope {
 public:
  explicit Envelope(int width)
      : columns_(static_cast<size_t>(width)), starts_(static_cast<size_t>(width)), heights_(columns_.size()) {}

  void build(const int32_t* rows, int width, int y) {
    size_t count = 0;
    for (int c = 0; c < width; ++c) {
      if (rows[c] < 0) continue;
      const double dy = y - rows[c];
      const double height = dy * dy + static_cast<double>(c) * c;
      double start = -1.0;
      while (count > 0) {
        const size_t top = count - 1;
        start = (height - heights_[top]) / (2.0 * (c - columns_[top]));
        if (start > starts_[top]) break;
        --count;
      }
      if (count == 0) start = -1.0;
      if (start >= width - 1) continue;
      columns_[count] = c;
      starts_[count] = start;
      heights_[count] = height;
      ++count;
    }
    count_ = count;
  }

  /// Calls visit(column, begin, end) for the pieces of [0, width) from left to right.
  template <class Visit>
  void for_each_piece(int width, Visit&& visit) const {
    int begin = 0;
    for (size_t k = 0; k < count_; ++k) {
      const int end = k + 1 < count_ ? static_cast<int>(starts_[k + 1] + 1.0) : width;  // starts_ > -1
      if (end > begin) visit(columns_[k], begin, end);
      begin = std::max(begin, end);
    }
  }

  bool empty() const { return count_ == 0; }

 private:
  std::vector<int32_t> columns_;
  std::vector<double> starts_;   ///< where parabola k becomes the lowest
  std::vector<double> heights_;  ///< dy^2 + c^2
  size_t count_ = 0;
};

SEAMOUNT_VECTORISED void root_row(float* row, int count, float scale) {
  for (int x = 0; x < count; ++x) row[x] = std::sqrt(row[x]) * scale;
}

void distance_row(const Envelope& envelope, const int32_t* rows, int width, int y, float cell, float* out) {
  if (envelope.empty()) {
    std::fill_n(out, width, std::numeric_limits<float>::infinity());
    return;
  }
  envelope.for_each_piece(width, [&](int column, int begin, int end) {
    const float dy = static_cast<float>(y - rows[column]);
    const float squared = dy * dy;
    for (int x = begin; x < end; ++x) {
      const float dx = static_cast<float>(x - column);
      out[x] = dx * dx + squared;
    }
  });
  root_row(out, width, cell);
}

void find_nearest(const Grid<uint8_t>& inside, Grid<int32_t>& nearest, ScalarField* distance, const RunContext& run) {
  nearest = Grid<int32_t>(inside.frame());
  if (distance != nullptr) *distance = ScalarField(inside.frame());
  if (inside.empty()) return;
  find_nearest_rows(inside, nearest.data(), run.part(0.0, 0.3));
  const float cell = static_cast<float>(inside.cell_m());
  parallel_rows(run.part(0.3, 1.0), inside.width(), inside.height(), [&](int begin, int end) {
    Envelope envelope(inside.width());
    std::vector<int32_t> rows(static_cast<size_t>(inside.width()));
    for (int y = begin; y < end; ++y) {
      int32_t* out = nearest.row(y).data();
      std::copy_n(out, inside.width(), rows.data());
      envelope.build(rows.data(), inside.width(), y);
      envelope.for_each_piece(inside.width(), [&](int column, int from, int to) {
        std::fill(out + from, out + to, rows[static_cast<size_t>(column)] * inside.width() + column);
      });
      if (distance != nullptr) distance_row(envelope, rows.data(), inside.width(), y, cell, distance->row(y).data());
    }
  });
}

}  // namespace

ScalarField distance_to(const Grid<uint8_t>& inside, const RunContext& run) {
  ScalarField distance(inside.frame());
  if (inside.empty()) return distance;
  Grid<int32_t> rows(inside.frame());
  find_nearest_rows(inside, rows.data(), run.part(0.0, 0.3));
  const float cell = static_cast<float>(inside.cell_m());
  parallel_rows(run.part(0.3, 1.0), inside.width(), inside.height(), [&](int begin, int end) {
    Envelope envelope(inside.width());
    for (int y = begin; y < end; ++y) {
      envelope.build(rows.row(y).data(), inside.width(), y);
      distance_row(envelope, rows.row(y).data(), inside.width(), y, cell, distance.row(y).data());
    }
  });
  return distance;
}

void nearest_feature(const Grid<uint8_t>& inside, Grid<int32_t>& nearest, const RunContext& run) {
  find_nearest(inside, nearest, nullptr, run);
}

void nearest_feature(const Grid<uint8_t>& inside, Grid<int32_t>& nearest, ScalarField& distance,
                     const RunContext& run) {
  find_nearest(inside, nearest, &distance, run);
}

}  // namespace seamount::geom

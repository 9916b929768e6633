#include "seamount/geom/solve/thin_plate.h"

#include <algorithm>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

/// The bending energy's gradient changes at most 64 times as fast as the heights.
constexpr float kStep = 1.0F / 64.0F;

/// The rows that a row's sweep reads and writes. y: where gradients are taken; x: the surface.
struct Rows {
  const float* above2;
  const float* above;
  const float* here;
  const float* below;
  const float* below2;
  const float* low;
  const float* high;
  float* x;
  float* next_y;
};

SEAMOUNT_INLINE void advance(const Rows& rows, size_t i, float gradient, float momentum) {
  float moved = rows.here[i] - kStep * gradient;
  moved = moved < rows.high[i] ? moved : rows.high[i];
  moved = moved > rows.low[i] ? moved : rows.low[i];
  rows.next_y[i] = moved + momentum * (moved - rows.x[i]);
  rows.x[i] = moved;
}

/// Cells with two neighbours on every side.
SEAMOUNT_VECTORISED void sweep_inner(const Rows& rows_in, size_t width, float momentum) {
  const Rows rows = rows_in;
  for (size_t i = 2; i + 2 < width; ++i) {
    const float near = rows.above[i] + rows.below[i] + rows.here[i - 1] + rows.here[i + 1];
    const float diagonal = rows.above[i - 1] + rows.above[i + 1] + rows.below[i - 1] + rows.below[i + 1];
    const float far = rows.above2[i] + rows.below2[i] + rows.here[i - 2] + rows.here[i + 2];
    advance(rows, i, 20.0F * rows.here[i] - 8.0F * near + 2.0F * diagonal + far, momentum);
  }
}

/// The gradient at any cell: derivatives that would reach beyond the frame are left out.
float gradient_at(const HeightField& y, int column, int row) {
  const auto inside = [&](int c, int r) { return y.contains(c, r); };
  float sum = 0.0F;
  for (int k = -1; k <= 1; ++k) {
    const float share = k == 0 ? -2.0F : 1.0F;
    const int c = column + k;
    const int r = row + k;
    if (inside(c - 1, row) && inside(c + 1, row)) sum += share * (y(c - 1, row) - 2.0F * y(c, row) + y(c + 1, row));
    if (inside(column, r - 1) && inside(column, r + 1))
      sum += share * (y(column, r - 1) - 2.0F * y(column, r) + y(column, r + 1));
  }
  for (int c = column - 1; c <= column; ++c) {
    for (int r = row - 1; r <= row; ++r) {
      if (!inside(c, r) || !inside(c + 1, r + 1)) continue;
      const float share = (c == column) == (r == row) ? 2.0F : -2.0F;
      sum += share * (y(c, r) - y(c + 1, r) - y(c, r + 1) + y(c + 1, r + 1));
    }
  }
  return sum;
}

class Plate {
 public:
  Plate(HeightField start, const HeightField& low, const HeightField& high)
      : low_(low), high_(high), x_(std::move(start)), y_(x_.frame()), next_y_(x_.frame()) {}

  HeightField relax(int sweeps, const RunContext& run) {
    clamp_start(run.part(0.0, 0.0));
    for (int k = 0; k < sweeps; ++k) {
      const float momentum = static_cast<float>(k) / static_cast<float>(k + 3);
      parallel_rows(run.part(static_cast<double>(k) / sweeps, (k + 1.0) / sweeps), x_.width(), x_.height(),
                    [&](int begin, int end) {
                      for (int row = begin; row < end; ++row) sweep_row(row, momentum);
                    });
      std::swap(y_, next_y_);
    }
    return std::move(x_);
  }

 private:
  void clamp_start(const RunContext& run) {
    parallel_rows(run, x_.width(), x_.height(), [&](int begin, int end) {
      for (int row = begin; row < end; ++row) {
        for (int c = 0; c < x_.width(); ++c)
          y_(c, row) = x_(c, row) = std::max(low_(c, row), std::min(high_(c, row), x_(c, row)));
      }
    });
  }

  void sweep_row(int row, float momentum) {
    const int width = x_.width();
    const auto line = [&](int r) { return y_.row(std::clamp(r, 0, y_.height() - 1)).data(); };
    const Rows rows = {line(row - 2),         line(row - 1),      line(row),
                       line(row + 1),         line(row + 2),      low_.row(row).data(),
                       high_.row(row).data(), x_.row(row).data(), next_y_.row(row).data()};
    const bool inner = row >= 2 && row + 2 < x_.height() && width > 4;
    if (inner) sweep_inner(rows, static_cast<size_t>(width), momentum);
    for (int c = 0; c < width; ++c) {
      if (inner && c == 2) c = width - 2;
      advance(rows, static_cast<size_t>(c), gradient_at(y_, c, row), momentum);
    }
  }

  const HeightField& low_;
  const HeightField& high_;
  HeightField x_, y_, next_y_;
};

}  // namespace

HeightField smooth_thin_plate(HeightField start, const HeightField& low, const HeightField& high, int sweeps,
                              const RunContext& run) {
  return Plate(std::move(start), low, high).relax(sweeps, run);
}

}  // namespace seamount::geom

#include "seamount/geom/grid/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/model/sample_known.h"

namespace seamount::geom {
namespace {

using Weights = std::array<double, 4>;

Weights catmull_rom_weights(double t) {
  return {t * (-0.5 + t * (1.0 - 0.5 * t)), 1.0 + t * t * (-2.5 + 1.5 * t), t * (0.5 + t * (2.0 - 1.5 * t)),
          t * t * (-0.5 + 0.5 * t)};
}

Weights bspline_weights(double t) {
  const double s = 1.0 - t;
  return {s * s * s / 6.0, (4.0 + t * t * (3.0 * t - 6.0)) / 6.0, (4.0 + s * s * (3.0 * s - 6.0)) / 6.0,
          t * t * t / 6.0};
}

double clamped_position(double position, int size) { return std::clamp(position, -2.0, size + 1.0); }

template <class MakeWeights>
float sample_cubic(const Grid<float>& grid, double column, double row, MakeWeights&& make_weights) {
  column = clamped_position(column, grid.width());
  row = clamped_position(row, grid.height());
  const double left = std::floor(column);
  const double top = std::floor(row);
  const Weights wx = make_weights(column - left);
  const Weights wy = make_weights(row - top);
  double sum = 0.0;
  for (int j = 0; j < 4; ++j) {
    double line = 0.0;
    for (int i = 0; i < 4; ++i) {
      line += wx[static_cast<size_t>(i)] * grid.clamped(static_cast<int>(left) + i - 1, static_cast<int>(top) + j - 1);
    }
    sum += wy[static_cast<size_t>(j)] * line;
  }
  return static_cast<float>(sum);
}

/// What each target cell along one axis takes from the source: weights[k] of cell first + k.
struct Axis {
  struct Tap {
    int first = 0;
    int count = 0;
    size_t weights = 0;  ///< index of the first weight
  };
  std::vector<Tap> taps;
  std::vector<float> weights;

  /// Adds a tap whose cells [first, first + values.size()) may lie outside [0, size).
  void add(int first, const std::vector<double>& values, int size) {
    const int low = std::clamp(first, 0, size - 1);
    const int high = std::clamp(first + static_cast<int>(values.size()) - 1, 0, size - 1);
    const size_t start = weights.size();
    std::vector<double> inside(static_cast<size_t>(high - low) + 1, 0.0);
    for (size_t k = 0; k < values.size(); ++k) {
      inside[static_cast<size_t>(std::clamp(first + static_cast<int>(k), 0, size - 1) - low)] += values[k];
    }
    for (const double w : inside) weights.push_back(static_cast<float>(w));
    taps.push_back({low, high - low + 1, start});
  }
};

/// Position of cell i of the whole target along the axis in source cells: offset + i ratio; of `target` cells from
/// `begin` on.
Axis make_axis(double offset, double ratio, int begin, int target, int source) {
  Axis axis;
  for (int i = begin; i < begin + target; ++i) {
    const double centre = clamped_position(offset + i * ratio, source);
    if (ratio <= 1.0 + 1e-9) {
      const double near = std::round(centre);
      const double snapped = std::abs(centre - near) < 1e-9 ? near : centre;
      const double left = std::floor(snapped);
      const Weights w = catmull_rom_weights(snapped - left);
      axis.add(static_cast<int>(left) - 1, {w[0], w[1], w[2], w[3]}, source);
      continue;
    }
    const double low = centre - 0.5 * ratio + 0.5;  // in cell edges: cell k covers [k, k + 1]
    const double high = low + ratio;
    const int first = static_cast<int>(std::floor(low + 1e-9));
    const int last = static_cast<int>(std::ceil(high - 1e-9)) - 1;
    std::vector<double> shares;
    for (int k = first; k <= last; ++k) {
      shares.push_back((std::min(high, k + 1.0) - std::max(low, static_cast<double>(k))) / ratio);
    }
    axis.add(first, shares, source);
  }
  return axis;
}

SEAMOUNT_VECTORISED void add_scaled(const float* row, float weight, float* sum, size_t count) {
  for (size_t i = 0; i < count; ++i) sum[i] += weight * row[i];
}

/// Taps along the row count from `first_column` of the source on, of which `source` has the part that is needed.
void resample_row(const HeightField& source, int first_column, const Axis& across, const Axis::Tap& tap,
                  const float* weights, std::vector<float>& mixed, std::span<float> out) {
  std::fill(mixed.begin(), mixed.end(), 0.0F);
  for (int k = 0; k < tap.count; ++k) {
    add_scaled(source.row(tap.first + k).data(), weights[k], mixed.data(), mixed.size());
  }
  for (size_t x = 0; x < out.size(); ++x) {
    const Axis::Tap& column = across.taps[x];
    float sum = 0.0F;
    const int first = column.first - first_column;
    for (int k = 0; k < column.count; ++k) {
      sum += across.weights[column.weights + static_cast<size_t>(k)] * mixed[static_cast<size_t>(first + k)];
    }
    out[x] = sum;
  }
}

/// First and last source cell whose centre lies in a target cell around `centre` (source cells).
std::array<int, 2> covered(double centre, double ratio, int size) {
  int first = static_cast<int>(std::ceil(centre - 0.5 * ratio - 1e-9));
  int last = static_cast<int>(std::ceil(centre + 0.5 * ratio - 1e-9)) - 1;
  if (last < first) first = last = static_cast<int>(std::floor(centre + 0.5));
  return {std::clamp(first, 0, size - 1), std::clamp(last, 0, size - 1)};
}

uint8_t most_frequent(const Grid<uint8_t>& source, std::array<int, 2> columns, std::array<int, 2> rows) {
  if (columns[0] == columns[1] && rows[0] == rows[1]) return source(columns[0], rows[0]);
  std::array<int, 256> counts{};
  for (int y = rows[0]; y <= rows[1]; ++y) {
    for (int x = columns[0]; x <= columns[1]; ++x) ++counts[source(x, y)];
  }
  return static_cast<uint8_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

}  // namespace

float sample_bilinear(const Grid<float>& grid, double column, double row) {
  column = clamped_position(column, grid.width());
  row = clamped_position(row, grid.height());
  const double left = std::floor(column);
  const double top = std::floor(row);
  const double tx = column - left;
  const double ty = row - top;
  const int x = static_cast<int>(left);
  const int y = static_cast<int>(top);
  const double upper = (1.0 - tx) * grid.clamped(x, y) + tx * grid.clamped(x + 1, y);
  const double lower = (1.0 - tx) * grid.clamped(x, y + 1) + tx * grid.clamped(x + 1, y + 1);
  return static_cast<float>((1.0 - ty) * upper + ty * lower);
}

float sample_bicubic(const Grid<float>& grid, double column, double row) {
  return sample_cubic(grid, column, row, catmull_rom_weights);
}

float sample_bspline(const Grid<float>& grid, double column, double row) {
  return sample_cubic(grid, column, row, bspline_weights);
}

namespace {

/// A cell near unknown ones: the mean of what is known in it, or bilinear between them.
float resample_known(const HeightField& source, const Axis::Tap& column, const float* across, const Axis::Tap& row,
                     const float* down) {
  double sum = 0.0, weight = 0.0, all = 0.0;
  for (int j = 0; j < row.count; ++j) {
    for (int i = 0; i < column.count; ++i) {
      const double w = static_cast<double>(across[i]) * static_cast<double>(down[j]);
      const float z = source(column.first + i, row.first + j);
      all += w;
      if (std::isnan(z)) continue;
      sum += w * z;
      weight += w;
    }
  }
  return 2.0 * weight >= all && weight > 0.0 ? static_cast<float>(sum / weight)
                                             : std::numeric_limits<float>::quiet_NaN();
}

}  // namespace

struct RowResampler::Axes {
  Axis across, down;
};

RowResampler::RowResampler(const GridFrame& source, const GridFrame& target)
    : source_(source), target_(target), ratio_(target.cell_m / source.cell_m) {
  const GridFrame whole = target.in_whole();
  axes_ = std::make_unique<const Axes>(
      Axes{make_axis(source.column(whole.x(0)), ratio_, target.first_column(), target.width, source.width),
           make_axis(source.row(whole.y(0)), ratio_, target.first_row(), target.height, source.height)});
}

RowResampler::~RowResampler() = default;

bool RowResampler::averages() const { return ratio_ > 1.0 + 1e-9; }

RowResampler::Span RowResampler::columns() const {
  int first = source_.width, last = 0;
  for (const Axis::Tap& tap : axes_->across.taps) {
    first = std::min(first, tap.first);
    last = std::max(last, tap.first + tap.count);
  }
  return {first, last - first};
}

RowResampler::Span RowResampler::rows(int begin, int end) const {
  int first = source_.height, last = 0;
  for (int y = begin; y < end; ++y) {
    const Axis::Tap& tap = axes_->down.taps[static_cast<size_t>(y)];
    first = std::min(first, tap.first);
    last = std::max(last, tap.first + tap.count);
  }
  return {first, last - first};
}

void RowResampler::row(const HeightField& part, int first_column, int first_row, int y, std::vector<float>& mixed,
                       std::span<float> out) const {
  const Axis& across = axes_->across;
  Axis::Tap tap = axes_->down.taps[static_cast<size_t>(y)];
  const float* weights = axes_->down.weights.data() + tap.weights;
  tap.first -= first_row;
  mixed.resize(static_cast<size_t>(part.width()));
  resample_row(part, first_column, across, tap, weights, mixed, out);
  const bool holes = any_void(out);
  for (int x = 0; holes && x < target_.width; ++x) {
    float& z = out[static_cast<size_t>(x)];
    if (!std::isnan(z)) continue;
    Axis::Tap column = across.taps[static_cast<size_t>(x)];
    column.first -= first_column;
    z = averages()
            ? resample_known(part, column, across.weights.data() + column.weights, tap, weights)
            : sample_known(part, std::clamp(source_.column(target_.x(x)), 0.0, source_.width - 1.0) - first_column,
                           std::clamp(source_.row(target_.y(y)), 0.0, source_.height - 1.0) - first_row);
  }
}

HeightField resample(const HeightField& source, const GridFrame& target, const RunContext& run) {
  const RowResampler resampler(source.frame(), target);
  HeightField result(target);
  parallel_rows(run, target.width, target.height, [&](int begin, int end) {
    std::vector<float> mixed;
    for (int y = begin; y < end; ++y) resampler.row(source, 0, 0, y, mixed, result.row(y));
  });
  return result;
}

Grid<uint8_t> resample_labels(const Grid<uint8_t>& source, const GridFrame& target, const RunContext& run) {
  const GridFrame& from = source.frame();
  const double ratio = target.cell_m / from.cell_m;
  Grid<uint8_t> result(target);
  parallel_rows(run, target.width, target.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::array<int, 2> rows = covered(from.row(target.y(y)), ratio > 1.0 ? ratio : 0.0, from.height);
      for (int x = 0; x < target.width; ++x) {
        const std::array<int, 2> columns = covered(from.column(target.x(x)), ratio > 1.0 ? ratio : 0.0, from.width);
        result(x, y) = most_frequent(source, columns, rows);
      }
    }
  });
  return result;
}

Grid<float> box_downsample(const Grid<float>& grid, int factor, const RunContext& run) {
  if (factor < 1 || grid.width() % factor != 0 || grid.height() % factor != 0) {
    throw InvalidArgument("factor", std::to_string(factor) + " does not divide a grid of " +
                                        std::to_string(grid.width()) + " x " + std::to_string(grid.height()));
  }
  GridFrame frame = grid.frame();
  frame.width /= factor;
  frame.height /= factor;
  frame.cell_m *= factor;
  return resample(grid, frame, run);
}

}  // namespace seamount::geom

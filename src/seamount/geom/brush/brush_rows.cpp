#include "seamount/geom/brush/brush_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

constexpr double kReach = 1.3;  // radii up to which a sample counts, though it may be heavier than nearer ones

/// exp(v) for v in [-80, 0] to about 1e-5, inlined into vector loops.
SEAMOUNT_INLINE float fast_exp(float v) {
  v = v > -80.0F ? v : -80.0F;
  const int32_t n = static_cast<int32_t>(v * 1.44269504F - 0.5F);
  const float r = v - static_cast<float>(n) * 0.69314718F;
  const float p = 1.0F + r * (1.0F + r * (0.5F + r * (0.16666667F + r * (0.04166667F + r * 0.00833333F))));
  return std::bit_cast<float>((n + 127) << 23) * p;
}

SEAMOUNT_VECTORISED void across_row(float x0, float dx, float scale, int first, int count, float* __restrict g,
                                    float* __restrict g2) {
  for (int i = 0; i < count; ++i) {
    const float x = x0 + static_cast<float>(first + i) * dx;
    g[i] = fast_exp(scale * x * x);
    g2[i] = g[i] * x * x;
  }
}

SEAMOUNT_VECTORISED void add_row(float mass, float squared, int count, const float* __restrict g,
                                 const float* __restrict g2, float* __restrict masses, float* __restrict squares) {
  for (int i = 0; i < count; ++i) {
    masses[i] += mass * g[i];
    squares[i] += mass * (g2[i] + squared * g[i]);
  }
}

SEAMOUNT_VECTORISED void add_pressure_row(float pressed, int count, const float* __restrict g,
                                          float* __restrict pressures) {
  for (int i = 0; i < count; ++i) pressures[i] += pressed * g[i];
}

/// A profile in radii, as the row kernel needs it.
struct Fall {
  float per_squared, plateau, inverse, curl;
};

/// BrushProfile::weight() of a squared distance; a little above 1 where that is below 0.
SEAMOUNT_INLINE float profile_at(float squared, const Fall& f) {
  constexpr float k = static_cast<float>(kBrushRounding);
  constexpr auto kWhole = static_cast<float>(1.0 / (1.0 + 1.00004999875 - kBrushRounding));  // 1 / G(1), halved
  const float v = squared * f.per_squared;
  const float rounded = (v + std::sqrt(v * v + k * k) - k) * kWhole;
  const float s = (std::sqrt(rounded > 0.0F ? rounded : 0.0F) - f.plateau) * f.inverse;
  const float down = s > 0.0F ? s : 0.0F;
  const float down2 = down * down + (rounded < 0.0F ? f.curl * rounded : 0.0F);
  const float rest = down2 < 1.0F ? 1.0F - down2 : 0.0F;
  return rest * rest * rest;
}

/// Sums become weights; `pressures` may be null: `pressure` all along.
SEAMOUNT_VECTORISED void weigh_row(const Fall f, float pressure, int count, const float* __restrict squares,
                                   const float* __restrict pressures, float* __restrict masses) {
  constexpr float kNone = 1e-30F;
  for (int i = 0; i < count; ++i) {
    const float inverse = 1.0F / (masses[i] > kNone ? masses[i] : kNone);
    const float weight = profile_at(squares[i] * inverse, f);
    const float pressed = pressures == nullptr ? pressure : pressures[i] * inverse;
    masses[i] = masses[i] > kNone ? pressed * weight : 0.0F;
  }
}

Fall fall_of(const BrushProfile& profile) {
  const double radius = profile.radius_m(), plateau = profile.plateau_m / radius;
  return {static_cast<float>(1.0 / (radius * radius)), static_cast<float>(plateau),
          static_cast<float>(radius / profile.fall_m), static_cast<float>(std::max(0.0, 1.0 - 4.0 * plateau))};
}

int bounded(double v, int low, int high) {
  return static_cast<int>(std::clamp(v, static_cast<double>(low), static_cast<double>(high)));
}

}  // namespace

CellWindow cells_of(const Box& box, const GridFrame& frame, double margin_m) {
  if (box.empty()) return {};
  return {bounded(std::floor(frame.column(box.low.x - margin_m)), 0, frame.width),
          bounded(std::floor(frame.row(box.high.y + margin_m)), 0, frame.height),
          bounded(std::ceil(frame.column(box.high.x + margin_m)) + 1.0, 0, frame.width),
          bounded(std::ceil(frame.row(box.low.y - margin_m)) + 1.0, 0, frame.height)};
}

GridFrame cells_frame(const Box& box, const GridFrame& frame, double margin_m) {
  const CellWindow window = cells_of(box, frame, margin_m);
  GridFrame whole = frame.in_whole();
  whole.width += frame.first_column();
  whole.height += frame.first_row();
  const CellWindow all = cells_of(box, whole, margin_m);
  GridFrame part = whole;
  part.width = all.right - all.left;
  part.height = all.bottom - all.top;
  part.west_m = whole.west_m + all.left * whole.cell_m;
  part.north_m = whole.north_m - all.top * whole.cell_m;
  const int left = frame.first_column() + window.left - all.left, top = frame.first_row() + window.top - all.top;
  return part.window(left, top, window.width(), window.bottom - window.top);
}

bool BrushBand::read(const BrushPath& path, const GridFrame& frame, int begin, int end) {
  window_ = cells_of(path.box, frame);
  whole_left_ = bounded(std::floor(frame.column(path.box.low.x)), -frame.first_column(), frame.width);
  window_.top = std::max(window_.top, begin);
  window_.bottom = std::min(window_.bottom, end);
  if (path.samples.empty() || window_.empty()) return false;
  const auto rows = static_cast<size_t>(window_.bottom - window_.top);
  const size_t cells = rows * static_cast<size_t>(window_.width());
  weights_.assign(cells, 0.0F);
  squares_.assign(cells, 0.0F);
  if (!path.even) pressures_.assign(cells, 0.0F);
  spans_.assign(rows, {window_.right, window_.left});
  for (const BrushSample& sample : path.samples) add(path, sample, frame);
  const Fall fall = fall_of(path.profile);
  const auto pressure = static_cast<float>(path.samples.front().pressure);
  for (int y = window_.top; y < window_.bottom; ++y) {
    const Span& s = spans_[static_cast<size_t>(y - window_.top)];
    if (s.from >= s.to) continue;
    const size_t first = index(s.from, y);
    weigh_row(fall, pressure, s.to - s.from, &squares_[first], path.even ? nullptr : &pressures_[first],
              &weights_[first]);
  }
  return true;
}

void BrushBand::add(const BrushPath& path, const BrushSample& sample, const GridFrame& frame) {
  const double reach = kReach * path.profile.radius_m();
  const int top = bounded(std::ceil(frame.row(sample.at.y + reach)), window_.top, window_.bottom);
  const int bottom = bounded(std::floor(frame.row(sample.at.y - reach)) + 1.0, window_.top, window_.bottom);
  const int left = bounded(std::ceil(frame.column(sample.at.x - reach)), window_.left, window_.right);
  const int right = bounded(std::floor(frame.column(sample.at.x + reach)) + 1.0, window_.left, window_.right);
  if (top >= bottom || left >= right) return;
  const double scale = -0.5 / (path.spread_m * path.spread_m);
  const int start = bounded(std::ceil(frame.column(sample.at.x - reach)), whole_left_, left);
  across_.resize(static_cast<size_t>(right - left));
  across2_.resize(across_.size());
  across_row(static_cast<float>(frame.x(start) - sample.at.x), static_cast<float>(frame.cell_m),
             static_cast<float>(scale), left - start, right - left, across_.data(), across2_.data());
  for (int y = top; y < bottom; ++y) {
    const double dy = frame.y(y) - sample.at.y;
    const double half = std::sqrt(std::max(0.0, reach * reach - dy * dy));
    const int from = bounded(std::ceil(frame.column(sample.at.x - half)), left, right);
    const int to = bounded(std::floor(frame.column(sample.at.x + half)) + 1.0, left, right);
    if (from >= to) continue;
    Span& span = spans_[static_cast<size_t>(y - window_.top)];
    span = {std::min(span.from, from), std::max(span.to, to)};
    const double mass = sample.mass * std::exp(scale * dy * dy);
    const size_t first = index(from, y), k = static_cast<size_t>(from - left);
    add_row(static_cast<float>(mass), static_cast<float>(dy * dy - sample.spread_m2), to - from, &across_[k],
            &across2_[k], &weights_[first], &squares_[first]);
    if (!path.even)
      add_pressure_row(static_cast<float>(mass * sample.pressure), to - from, &across_[k], &pressures_[first]);
  }
}

}  // namespace seamount::geom

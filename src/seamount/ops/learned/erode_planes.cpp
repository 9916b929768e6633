#include "seamount/ops/learned/erode_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/learned/erosion_estimate.h"
#include "seamount/ops/learned/plane_lanes.h"
#include "seamount/ops/learned/plane_math.h"

namespace seamount::learned {
namespace {

constexpr double kMargin = 1.0 / 24;        ///< of the map's longer side: land goes on beyond the border
constexpr double kNear = 3.0, kFar = 12.0;  ///< deviation of means of the ground, in cells
constexpr double kLeastUnit = 1e-6;         ///< metres: what changes less does not change

/// The map with `cells` more on all sides, as at its edge: rivers leave by its valleys.
HeightField extended(const HeightField& map, int cells) {
  GridFrame frame = map.frame();
  frame.width += 2 * cells;
  frame.height += 2 * cells;
  frame.west_m -= cells * frame.cell_m;
  frame.north_m += cells * frame.cell_m;
  HeightField out(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) out(x, y) = map.clamped(x - cells, y - cells);
  }
  return out;
}

/// A field without its margin.
template <class T>
Grid<T> without_margin(const Grid<T>& field, const GridFrame& frame, int margin) {
  Grid<T> out(frame);
  for (int y = 0; y < frame.height; ++y)
    std::copy_n(field.row(y + margin).begin() + margin, frame.width, out.row(y).begin());
  return out;
}

ScalarField blurred(ScalarField field, double cells, const RunContext& run) {
  geom::gaussian_blur(field, cells * field.cell_m(), run);
  return field;
}

/// Large values keep their order and become small.
SEAMOUNT_VECTORISED void soft_row(const float* row, float factor, int width, float* out) {
  for (int x = 0; x < width; ++x) out[x] = fast_asinh(factor * row[x]);
}

SEAMOUNT_VECTORISED void soft_difference_row(const float* row, const float* from, float factor, int width, float* out) {
  for (int x = 0; x < width; ++x) out[x] = fast_asinh(factor * (row[x] - from[x]));
}

SEAMOUNT_VECTORISED void scale_row(const float* row, float factor, int width, float* out) {
  for (int x = 0; x < width; ++x) out[x] = factor * row[x];
}

/// log2 of how much passed.
SEAMOUNT_VECTORISED void log_row(const float* row, float factor, float plus, int width, float* out) {
  constexpr float kPerLog = 1.44269504F;
  for (int x = 0; x < width; ++x) out[x] = kPerLog * fast_log(plus + factor * row[x]);
}

SEAMOUNT_VECTORISED void slope_row(const float* north, const float* row, const float* south, float per_m, int width,
                                   float* out) {
  for (int x = 0; x < width; ++x) {
    const float east = row[x + 1 < width ? x + 1 : x] - row[x > 0 ? x - 1 : 0], down = south[x] - north[x];
    out[x] = per_m * std::sqrt(east * east + down * down);
  }
}

SEAMOUNT_VECTORISED void sea_row(const float* row, float sea, int width, float* out) {
  for (int x = 0; x < width; ++x) out[x] = fast_tanh((row[x] - sea) / 60);
}

}  // namespace

ErodePlanes::ErodePlanes(const HeightField& terrain, double years, double sea_m, const RunContext& run)
    : terrain_(terrain), years_(years), sea_m_(sea_m) {
  const GridFrame& frame = terrain.frame();
  const int margin = static_cast<int>(std::ceil(kMargin * std::max(frame.width, frame.height)));
  const ErosionEstimate estimate = estimate_erosion(extended(terrain, margin), years, sea_m, run.part(0, 0.7));
  detail_ = without_margin(estimate.made.heights, frame, margin);
  base_ = coarse_ = ScalarField(frame);
  double sum = 0;
  for (size_t i = 0; i < base_.size(); ++i) {
    base_.data()[i] = detail_.data()[i] - terrain.data()[i];
    sum += std::abs(base_.data()[i]);
  }
  unit_m_ = sum / static_cast<double>(frame.cells());
  if (unit_m_ < kLeastUnit) unit_m_ = 0;
  if (unit_m_ == 0) return;
  const auto per_unit = static_cast<float>(1 / unit_m_);
  const ScalarField smooth = blurred(detail_, kNear, run);
  drained_ = water_m_ = descent_ = load_ = ScalarField(frame);
  const auto steps = geom::flow_steps(estimate.worn.width());
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const int64_t i = static_cast<int64_t>(y + margin) * estimate.worn.width() + x + margin;
        coarse_(x, y) = (estimate.worn.data()[i] - terrain(x, y)) * per_unit;
        base_(x, y) *= per_unit;
        detail_(x, y) = (detail_(x, y) - smooth(x, y)) * per_unit;
        drained_(x, y) = static_cast<float>(estimate.cells.data()[i]);
        water_m_(x, y) = estimate.filled.data()[i] - estimate.worn.data()[i];
        load_(x, y) = estimate.made.load.data()[i];
        const uint8_t way = estimate.directions.data()[i];
        descent_(x, y) = way >= 8 ? 0.0F
                                  : (estimate.filled.data()[i] - estimate.filled.data()[i + steps[way]]) /
                                        (geom::kFlowLength[way] * static_cast<float>(frame.cell_m));
      }
      log_row(drained_.row(y).data(), 1, 0, frame.width, drained_.row(y).data());
      log_row(load_.row(y).data(), per_unit, 1, frame.width, load_.row(y).data());
    }
  });
  near_ = blurred(terrain, kNear, run);
  far_ = blurred(terrain, kFar, run);
}

Planes ErodePlanes::planes() const {
  Planes out{terrain_.width(), terrain_.height(), kErodePlanes, {}};
  out.fill = [this](int begin, int end, std::span<float> values) {
    const size_t row = static_cast<size_t>(terrain_.width()) * kErodePlanes;
    for (int y = begin; y < end; ++y) fill_row(y, values.data() + static_cast<size_t>(y - begin) * row);
  };
  return out;
}

void ErodePlanes::fill_row(int y, float* values) const {
  const int width = terrain_.width();
  const auto cell = static_cast<float>(terrain_.cell_m()), unit = static_cast<float>(unit_m_);
  const float* const z = terrain_.row(y).data();
  PlaneLanes p(width, kErodePlanes);
  soft_row(base_.row(y).data(), 1, width, p[0]);
  soft_row(coarse_.row(y).data(), 1, width, p[1]);
  soft_row(detail_.row(y).data(), 1, width, p[2]);
  soft_difference_row(z, near_.row(y).data(), 1 / cell, width, p[3]);
  soft_difference_row(z, near_.row(y).data(), 1 / unit, width, p[4]);
  soft_difference_row(z, far_.row(y).data(), 1 / (3 * cell), width, p[5]);
  slope_row(terrain_.row(std::max(y - 1, 0)).data(), z, terrain_.row(std::min(y + 1, terrain_.height() - 1)).data(),
            1 / (2 * cell), width, p[6]);
  scale_row(drained_.row(y).data(), 1.0F / 6, width, p[7]);
  soft_row(water_m_.row(y).data(), 1 / unit, width, p[8]);
  soft_row(descent_.row(y).data(), 2, width, p[9]);
  scale_row(load_.row(y).data(), 1.0F / 4, width, p[10]);
  sea_row(z, static_cast<float>(sea_m_), width, p[11]);
  std::fill_n(p[12], width, static_cast<float>(std::log2(std::max(years_, kFewestYears) / 20000) / 3));
  std::fill_n(p[13], width, static_cast<float>(std::log2(terrain_.cell_m() / 40) / 2));
  std::fill_n(p[14], width, static_cast<float>(std::log2(unit_m_ / terrain_.cell_m()) / 3));
  p.interleave(values);
}

}  // namespace seamount::learned

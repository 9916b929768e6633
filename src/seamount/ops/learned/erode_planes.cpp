#include "seamount/ops/learned/erode_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/learned/erosion_estimate.h"

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
float soft(double x) { return static_cast<float>(std::asinh(x)); }

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
        drained_(x, y) = std::log2(static_cast<float>(estimate.cells.data()[i]));
        water_m_(x, y) = estimate.filled.data()[i] - estimate.worn.data()[i];
        load_(x, y) = std::log2(1 + estimate.made.load.data()[i] * per_unit);
        const uint8_t way = estimate.directions.data()[i];
        descent_(x, y) = way >= 8 ? 0.0F
                                  : (estimate.filled.data()[i] - estimate.filled.data()[i + steps[way]]) /
                                        (geom::kFlowLength[way] * static_cast<float>(frame.cell_m));
      }
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
  const double cell = terrain_.cell_m();
  const auto age = static_cast<float>(std::log2(std::max(years_, kFewestYears) / 20000) / 3);
  const auto scale = static_cast<float>(std::log2(cell / 40) / 2),
             unit = static_cast<float>(std::log2(unit_m_ / cell) / 3);
  for (int x = 0; x < terrain_.width(); ++x) {
    float* const p = values + static_cast<size_t>(x) * kErodePlanes;
    const float z = terrain_(x, y);
    const float east = terrain_.clamped(x + 1, y) - terrain_.clamped(x - 1, y),
                south = terrain_.clamped(x, y + 1) - terrain_.clamped(x, y - 1);
    p[0] = soft(base_(x, y));
    p[1] = soft(coarse_(x, y));
    p[2] = soft(detail_(x, y));
    p[3] = soft((z - near_(x, y)) / cell);
    p[4] = soft((z - near_(x, y)) / unit_m_);
    p[5] = soft((z - far_(x, y)) / (3 * cell));
    p[6] = static_cast<float>(std::hypot(east, south) / (2 * cell));
    p[7] = drained_(x, y) / 6;
    p[8] = soft(water_m_(x, y) / unit_m_);
    p[9] = soft(2 * descent_(x, y));
    p[10] = load_(x, y) / 4;
    p[11] = std::tanh(static_cast<float>((z - sea_m_) / 60));
    p[12] = age;
    p[13] = scale;
    p[14] = unit;
  }
}

}  // namespace seamount::learned

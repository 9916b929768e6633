#include "seamount/ops/learned/erode_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/pyramid.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/incise.h"

namespace seamount::learned {
namespace {

/// K between erosion.run's of bedrock and of debris, which makes the least error; the tangent of what rock stands.
constexpr double kErodibility = 1.5e-5, kSteepest = 0.84;
constexpr double kChannel_m2 = 1000;
constexpr double kMargin = 1.0 / 24;        ///< of the map's longer side: land goes on beyond the border
constexpr double kLonger = 8.0;             ///< years of the estimate of what will be
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

/// Where water runs on a terrain with its margin.
struct Ways {
  HeightField ground, filled;
  geom::FlowDirections directions;
  Grid<uint32_t> cells;

  Ways(HeightField extended_ground, float sea_m, const RunContext& run)
      : ground(std::move(extended_ground)),
        filled(geom::fill_depressions(ground, sea_m, run)),
        directions(geom::flow_directions(filled, sea_m, run)),
        cells(geom::flow_accumulation(directions, run)) {}

  geom::Incised incised(double years, const RunContext& run) const {
    const double cell_m2 = ground.cell_m() * ground.cell_m();
    geom::Incised out = geom::incise(ground, directions, cells,
                                     {.rate = static_cast<float>(kErodibility * years),
                                      .deposition = 1.0F,
                                      .steepest = static_cast<float>(kSteepest),
                                      .channel_cells = static_cast<float>(std::min(0.9, kChannel_m2 / cell_m2))},
                                     run);
    geom::limit_rise(out.heights, static_cast<float>(kSteepest));
    return out;
  }
};

/// heights - ground over the frame without its margin.
ScalarField change(const HeightField& heights, const HeightField& ground, const GridFrame& frame, int margin) {
  ScalarField out(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) out(x, y) = heights(x + margin, y + margin) - ground(x + margin, y + margin);
  }
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
  const auto sea = static_cast<float>(sea_m);
  const int margin = static_cast<int>(std::ceil(kMargin * std::max(frame.width, frame.height)));
  const Ways ways(extended(terrain, margin), sea, run.part(0, 0.4));
  const geom::Incised now = ways.incised(years, run);
  base_ = change(now.heights, ways.ground, frame, margin);
  double sum = 0;
  for (const float dz : base_.cells()) sum += std::abs(dz);
  unit_m_ = sum / static_cast<double>(frame.cells());
  if (unit_m_ < kLeastUnit) unit_m_ = 0;
  if (unit_m_ == 0) return;
  const auto per_unit = static_cast<float>(1 / unit_m_);
  later_ = change(ways.incised(kLonger * years, run).heights, ways.ground, frame, margin);
  const HeightField half = geom::halved(ways.ground, run);
  const Ways wide(geom::halved(half, run), sea, run);
  ScalarField coarse = wide.incised(years, run).heights;
  for (size_t i = 0; i < coarse.size(); ++i) coarse.data()[i] -= wide.ground.data()[i];
  const ScalarField fine = geom::doubled(geom::doubled(coarse, half.frame(), run), ways.ground.frame(), run);
  coarse_ = drained_ = water_m_ = descent_ = load_ = ScalarField(frame);
  const auto steps = geom::flow_steps(ways.ground.width());
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const int64_t i = static_cast<int64_t>(y + margin) * ways.ground.width() + x + margin;
        coarse_(x, y) = fine.data()[i] * per_unit;
        base_(x, y) *= per_unit;
        later_(x, y) *= per_unit;
        drained_(x, y) = std::log2(static_cast<float>(ways.cells.data()[i]));
        water_m_(x, y) = ways.filled.data()[i] - ways.ground.data()[i];
        load_(x, y) = std::log2(1 + now.load.data()[i] * per_unit);
        const uint8_t way = ways.directions.data()[i];
        descent_(x, y) = way >= 8 ? 0.0F
                                  : (ways.filled.data()[i] - ways.filled.data()[i + steps[way]]) /
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
    p[1] = soft(later_(x, y));
    p[2] = soft(coarse_(x, y));
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

#include "seamount/ops/hydrology/flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/inland.h"
#include "seamount/ops/hydrology/catchments.h"
#include "seamount/ops/hydrology/flow_spread.h"
#include "seamount/ops/hydrology/mostly_sea.h"

namespace seamount::hydrology {
namespace {

using geom::FlowDirections;

/// Bearing of a direction in eighths of a turn counter-clockwise from east.
float bearing_deg(float eighths) {
  if (eighths < 0.0F) return -1.0F;
  const float bearing = 90.0F - 45.0F * eighths;
  return bearing < 0.0F ? bearing + 360.0F : bearing;
}

template <class From, class To, class Function>
void map_cells(const Grid<From>& from, Grid<To>& to, const RunContext& run, const Function& function) {
  parallel_rows(run, from.width(), from.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < from.width(); ++x) to(x, y) = function(from(x, y));
    }
  });
}

/// Catchments by number, from the largest on.
ScalarField number_basins(const FlowDirections& directions, const Grid<uint32_t>& cells, float sea,
                          const HeightField& terrain, const RunContext& run) {
  std::vector<int32_t> mouths;
  Grid<int32_t> basins(directions.frame(), -1);
  for (int64_t i = 0; i < directions.frame().cells(); ++i) {
    if (directions.data()[i] != geom::kOutlet) continue;
    if (terrain.data()[i] <= sea && cells.data()[i] == 1)
      basins.data()[i] = 0;
    else
      mouths.push_back(static_cast<int32_t>(i));
  }
  std::stable_sort(mouths.begin(), mouths.end(),
                   [&](int32_t a, int32_t b) { return cells.data()[a] > cells.data()[b]; });
  for (size_t i = 0; i < mouths.size(); ++i) basins.data()[mouths[i]] = static_cast<int32_t>(i + 1);
  geom::label_upstream(directions, basins, run);
  for (const int32_t mouth : mouths)
    if (terrain.data()[mouth] == geom::kUnknownGround) basins.data()[mouth] = 0;
  ScalarField numbers(directions.frame());
  map_cells(basins, numbers, run, [](int32_t basin) { return static_cast<float>(basin); });
  return numbers;
}

}  // namespace

Flow flow(const HeightField& terrain, const FlowParams& params, const RunContext& run) {
  check_params(params);
  say_mostly_sea(terrain, params.sea, run);
  const float sea = params.sea ? 0.0F : geom::kNoSea;
  const GridFrame& frame = terrain.frame();
  Flow out{geom::fill_depressions(geom::raise_inland(terrain, sea, params.min_sea_m2, run), sea, run.part(0.0, 0.4)),
           ScalarField(frame),
           ScalarField(frame),
           ScalarField(frame),
           {},
           {}};
  const FlowDirections d8 = geom::flow_directions(out.terrain, sea, run.part(0.4, 0.5));
  const Grid<uint32_t> cells = geom::flow_accumulation(d8, run.part(0.5, 0.6));
  out.basins = number_basins(d8, cells, sea, out.terrain, run);
  constexpr double kCatchmentPart = 500.0;
  out.catchments = trace_catchments(
      out.basins, cells, params.min_catchment_m2.value_or(frame.width_m() * frame.height_m() / kCatchmentPart), run);
  ScalarField eighths(frame);
  if (params.method == FlowMethod::dinf) {
    eighths = dinf_directions(out.terrain, d8, sea, run.part(0.6, 0.7));
    out.cells = dinf_accumulation(eighths, d8, run.part(0.7, 0.9));
  } else {
    map_cells(d8, eighths, run, [](uint8_t code) { return code < 8 ? static_cast<float>(code) : -1.0F; });
    if (params.method == FlowMethod::mfd)
      out.cells = mfd_accumulation(out.terrain, d8, sea, params.exponent, run.part(0.6, 0.9));
    else
      map_cells(cells, out.cells, run, [](uint32_t count) { return static_cast<float>(count); });
  }
  const auto cell_m2 = static_cast<float>(frame.cell_m * frame.cell_m);
  map_cells(eighths, out.direction_deg, run, bearing_deg);
  map_cells(out.cells, out.area_m2, run.part(0.9, 1.0), [&](float count) { return count * cell_m2; });
  geom::forget_unknown(out.terrain);
  for (size_t i = 0; i < out.terrain.size(); ++i) {
    if (!std::isnan(out.terrain.data()[i])) continue;
    for (ScalarField* field : {&out.cells, &out.area_m2, &out.direction_deg, &out.basins})
      field->data()[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return out;
}

}  // namespace seamount::hydrology

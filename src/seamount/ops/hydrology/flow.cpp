#include "seamount/ops/hydrology/flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/inland.h"
#include "seamount/ops/hydrology/catchments.h"
#include "seamount/ops/hydrology/ends_of_flow.h"
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

/// Where a catchment's water arrives: a cell, or sinks that hang together.
struct Mouth {
  int32_t first;  ///< in `members`
  int32_t count;
  uint64_t drained;
};

/// Every end of flow that has a catchment; open water that only takes itself gets basin 0.
struct Mouths {
  std::vector<Mouth> all;
  std::vector<int32_t> members;
};

Mouths find_mouths(const FlowDirections& directions, const Grid<uint32_t>& cells, const ScalarField* sinks, float sea,
                   const HeightField& terrain, Grid<int32_t>& basins) {
  Mouths mouths;
  const auto join = [&](int32_t cell) {
    basins.data()[cell] = 0;  // taken; numbered later
    mouths.members.push_back(cell);
  };
  const int width = terrain.width();
  for (int64_t i = 0; i < directions.frame().cells(); ++i) {
    if (directions.data()[i] != geom::kOutlet || basins.data()[i] >= 0) continue;
    const bool sink = sinks != nullptr && is_sink(*sinks, i);
    if (!sink && terrain.data()[i] <= sea && cells.data()[i] == 1) {
      basins.data()[i] = 0;
      continue;
    }
    const auto first = static_cast<int32_t>(mouths.members.size());
    join(static_cast<int32_t>(i));
    for (auto next = static_cast<size_t>(first); sink && next < mouths.members.size(); ++next) {
      const int32_t cell = mouths.members[next];
      for (size_t k = 0; k < 8; ++k) {
        const int x = cell % width + geom::kFlowDx[k], y = cell / width + geom::kFlowDy[k];
        if (terrain.contains(x, y) && is_sink(*sinks, y * width + x) && basins(x, y) < 0) join(y * width + x);
      }
    }
    Mouth mouth{first, static_cast<int32_t>(mouths.members.size()) - first, 0};
    for (int32_t k = first; k < first + mouth.count; ++k)
      mouth.drained += cells.data()[mouths.members[static_cast<size_t>(k)]];
    mouths.all.push_back(mouth);
  }
  return mouths;
}

/// Catchments by number, from the largest on.
ScalarField number_basins(const FlowDirections& directions, const Grid<uint32_t>& cells, const ScalarField* sinks,
                          float sea, const HeightField& terrain, const RunContext& run) {
  Grid<int32_t> basins(directions.frame(), -1);
  Mouths mouths = find_mouths(directions, cells, sinks, sea, terrain, basins);
  std::stable_sort(mouths.all.begin(), mouths.all.end(),
                   [](const Mouth& a, const Mouth& b) { return a.drained > b.drained; });
  const auto number = [&](size_t mouth, int32_t basin) {
    const Mouth& here = mouths.all[mouth];
    for (int32_t k = here.first; k < here.first + here.count; ++k)
      basins.data()[mouths.members[static_cast<size_t>(k)]] = basin;
  };
  for (size_t i = 0; i < mouths.all.size(); ++i) number(i, static_cast<int32_t>(i + 1));
  geom::label_upstream(directions, basins, run);
  for (const int32_t cell : mouths.members)
    if (terrain.data()[cell] == geom::kUnknownGround) basins.data()[cell] = 0;
  ScalarField numbers(directions.frame());
  map_cells(basins, numbers, run, [](int32_t basin) { return static_cast<float>(basin); });
  return numbers;
}

}  // namespace

double least_catchment_m2(const FlowParams& params, const GridFrame& frame) {
  constexpr double kPart = 500.0;
  return params.min_catchment_m2.value_or(frame.width_m() * frame.height_m() / kPart);
}

Flow flow(const HeightField& terrain, const ScalarField* sinks, const FlowParams& params, const RunContext& run) {
  check_params(params);
  say_mostly_sea(terrain, params.sea, run);
  EndsOfFlow ends = ends_of_flow(terrain, sinks, params.sea, params.min_sea_m2, run);
  const float sea = ends.sea;
  const GridFrame& frame = terrain.frame();
  Flow out{geom::fill_depressions(ends.ground, sea, run.part(0.0, 0.4)),
           ScalarField(frame),
           ScalarField(frame),
           ScalarField(frame),
           {},
           {}};
  ends.ground = {};
  const FlowDirections d8 = geom::flow_directions(out.terrain, sea, run.part(0.4, 0.5));
  const Grid<uint32_t> cells = geom::flow_accumulation(d8, run.part(0.5, 0.6));
  out.basins = number_basins(d8, cells, sinks, sea, out.terrain, run);
  out.catchments = trace_catchments(out.basins, cells, least_catchment_m2(params, frame), run);
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
  restore_lowered(out.terrain, terrain, sinks, sea);
  geom::forget_unknown(out.terrain);
  for (size_t i = 0; i < out.terrain.size(); ++i) {
    if (!std::isnan(out.terrain.data()[i])) continue;
    for (ScalarField* field : {&out.cells, &out.area_m2, &out.direction_deg, &out.basins})
      field->data()[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return out;
}

}  // namespace seamount::hydrology

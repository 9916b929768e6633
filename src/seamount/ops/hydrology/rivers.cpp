#include "seamount/ops/hydrology/rivers.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/inland.h"
#include "seamount/geom/water/skeleton.h"
#include "seamount/ops/hydrology/ends_of_flow.h"
#include "seamount/ops/hydrology/mostly_sea.h"
#include "seamount/ops/hydrology/network.h"
#include "seamount/ops/hydrology/ridge_flow.h"

namespace seamount::hydrology {
namespace {

constexpr double kSecondsPerYear = 365.25 * 86400.0;

/// Cells that a channel's catchment must have.
double threshold(const std::optional<double>& min_area_m2, const HeightField& terrain, float sea) {
  constexpr double kPart = 500.0;
  if (min_area_m2) return std::max(2.0, *min_area_m2 / (terrain.cell_m() * terrain.cell_m()));
  const auto land = std::count_if(terrain.cells().begin(), terrain.cells().end(), [&](float z) { return z > sea; });
  return std::max(2.0, static_cast<double>(land) / kPart);
}

ValuedLine describe_link(const Link& link, const GridFrame& frame) {
  ValuedLine line{geom::smooth_chain(link.cells, frame), static_cast<double>(link.order), false};
  line.attributes = {{"order", static_cast<double>(link.order)},
                     {"length_m", geom::line_length(line.points)},
                     {"area_m2", link.drained * frame.cell_m * frame.cell_m}};
  return line;
}

/// The edge cuts slopes in two and makes ridges of them that are none.
void clear_edge(Grid<uint8_t>& mask) {
  constexpr int kEdge = 2;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (std::min({x, y, mask.width() - 1 - x, mask.height() - 1 - y}) < kEdge) mask(x, y) = 0;
    }
  }
}

/// A river ends on the last ground that is known, unless it has no other.
void end_on_known_ground(Link& link, const HeightField& terrain) {
  if (link.cells.size() > 2 && terrain.data()[link.cells.back()] == geom::kUnknownGround) link.cells.pop_back();
}

/// How much higher the first cell of a link is than its last; 0 where that is not known.
double fall(const Link& link, const HeightField& terrain) {
  const double difference =
      static_cast<double>(terrain.data()[link.cells.front()]) - static_cast<double>(terrain.data()[link.cells.back()]);
  return std::isfinite(difference) ? difference : 0.0;
}

}  // namespace

Drawing rivers(const HeightField& terrain, const ScalarField* sinks, const RiversParams& params,
               const RunContext& run) {
  check_params(params);
  say_mostly_sea(terrain, params.sea, run);
  const GridFrame& frame = terrain.frame();
  EndsOfFlow ends = ends_of_flow(terrain, sinks, params.sea, params.min_sea_m2, run);
  const float sea = ends.sea;
  HeightField filled = geom::fill_depressions(ends.ground, sea, run.part(0.0, 0.5));
  ends.ground = {};
  const geom::FlowDirections directions = geom::flow_directions(filled, sea, run.part(0.5, 0.6));
  ScalarField cells(frame);
  {
    const Grid<uint32_t> counts = geom::flow_accumulation(directions, run.part(0.6, 0.8));
    std::transform(counts.cells().begin(), counts.cells().end(), cells.cells().begin(),
                   [](uint32_t count) { return static_cast<float>(count); });
  }
  const double least = threshold(params.min_area_m2, filled, sea);
  restore_lowered(filled, terrain, sinks, sea);
  Drawing drawing;
  drawing.crs = frame.crs;
  for (Link& link : find_links(directions, cells, least, nullptr, run)) {
    end_on_known_ground(link, filled);
    ValuedLine line = describe_link(link, frame);
    const double discharge = link.drained * frame.cell_m * frame.cell_m * 1e-3 * params.runoff_mm_yr / kSecondsPerYear;
    line.attributes.push_back({"discharge_m3_s", discharge});
    line.attributes.push_back({"width_m", params.width_factor * std::sqrt(discharge)});
    line.attributes.push_back({"fall_m", fall(link, filled)});
    drawing.lines.push_back(std::move(line));
  }
  if (drawing.lines.empty()) run.say("no river: nothing drains an area as large as min_area_m2");
  return drawing;
}

Drawing ridges(const HeightField& terrain, const RidgesParams& params, const RunContext& run) {
  check_params(params);
  say_mostly_sea(terrain, params.sea, run);
  const GridFrame& frame = terrain.frame();
  float sea = params.sea ? 0.0F : geom::kNoSea;
  const HeightField ground = geom::lower_sea(terrain, sea, params.min_sea_m2, run);
  RidgeFlow flow = ridge_flow(ground, sea, run);
  clear_edge(flow.land);
  Drawing drawing;
  drawing.crs = frame.crs;
  for (Link& link :
       find_links(flow.directions, flow.cells, threshold(params.min_area_m2, ground, sea), &flow.land, run)) {
    end_on_known_ground(link, ground);
    ValuedLine line = describe_link(link, frame);
    line.attributes.push_back({"rise_m", -fall(link, ground)});
    drawing.lines.push_back(std::move(line));
  }
  if (drawing.lines.empty()) run.say("no ridge parts areas as large as min_area_m2");
  return drawing;
}

}  // namespace seamount::hydrology

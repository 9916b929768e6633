#include "seamount/ops/hydrology/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/inland.h"
#include "seamount/geom/water/skeleton.h"
#include "seamount/ops/hydrology/local_relief.h"
#include "seamount/ops/hydrology/network.h"
#include "seamount/ops/hydrology/ridge_flow.h"
#include "seamount/ops/hydrology/tally.h"

namespace seamount::hydrology {
namespace {

/// Length of the lines through a network's links, in metres.
double length_of(const std::vector<Link>& links, const GridFrame& frame) {
  double length = 0.0;
  for (const Link& link : links) length += geom::line_length(geom::smooth_chain(link.cells, frame));
  return length;
}

/// Where both ends are land.
Unevenness unevenness_at(const HeightField& terrain, float sea, int lag, const RunContext& run) {
  struct Sum {
    double squares = 0.0;
    int64_t count = 0;
    Sum& operator+=(const Sum& other) {
      squares += other.squares;
      count += other.count;
      return *this;
    }
    void add(float a, float b, float sea_level) {
      if (a <= sea_level || b <= sea_level) return;
      const double difference = static_cast<double>(a) - static_cast<double>(b);
      squares += difference * difference;
      ++count;
    }
  };
  constexpr int64_t kRows = 32;
  const Sum sum = parallel_sum<Sum>(run, terrain.height(), kRows, [&](int64_t begin, int64_t end) {
    Sum part;
    for (int y = static_cast<int>(begin); y < end; ++y) {
      const auto row = terrain.row(y);
      for (size_t x = 0; x + static_cast<size_t>(lag) < row.size(); ++x)
        part.add(row[x], row[x + static_cast<size_t>(lag)], sea);
      if (y + lag >= terrain.height()) continue;
      const auto below = terrain.row(y + lag);
      for (size_t x = 0; x < row.size(); ++x) part.add(row[x], below[x], sea);
    }
    return part;
  });
  return {lag * terrain.cell_m(), sum.count > 0 ? std::sqrt(sum.squares / static_cast<double>(sum.count)) : 0.0};
}

std::vector<Unevenness> unevenness_of(const HeightField& terrain, float sea, const RunContext& run) {
  std::vector<Unevenness> curve;
  const int longest = std::max(terrain.width(), terrain.height()) / 4;
  for (int lag = 1; lag <= longest; lag *= 2) {
    const Unevenness point = unevenness_at(terrain, sea, lag, run);
    if (point.rms_m > 0.0) curve.push_back(point);
  }
  return curve;
}

/// Rivers with their orders, drainage areas, and slope over area.
void survey_rivers(const HeightField& terrain, const SurveyPlan& plan, Survey& out, const RunContext& run) {
  const GridFrame& frame = terrain.frame();
  const double cell_m2 = frame.cell_m * frame.cell_m;
  HeightField filled = geom::fill_depressions(terrain, plan.sea_level_m, run);
  const geom::FlowDirections directions = geom::flow_directions(filled, plan.sea_level_m, run);
  Grid<uint32_t> counts = geom::flow_accumulation(directions, run);
  out.channels = channel_slopes(terrain, filled, directions, counts, plan.sea_level_m, run);
  filled = {};
  const auto is_land = [&](int64_t i) { return terrain.data()[i] > plan.sea_level_m; };
  out.area = gather(
                 Tally(0.0F, true), frame.cells(), is_land,
                 [&](int64_t i) { return static_cast<float>(counts.data()[i]); }, run)
                 .logarithmic(cell_m2);
  ScalarField cells(frame);
  std::transform(counts.cells().begin(), counts.cells().end(), cells.cells().begin(),
                 [](uint32_t count) { return static_cast<float>(count); });
  counts = {};
  const std::vector<Link> links = find_links(directions, cells, std::max(2.0, plan.channel_m2 / cell_m2), nullptr, run);
  out.streams = streams_by_order(links);
  out.river_m = length_of(links, frame);
}

double ridge_length(const HeightField& terrain, const SurveyPlan& plan, const RunContext& run) {
  const GridFrame& frame = terrain.frame();
  const RidgeFlow ridges = ridge_flow(terrain, plan.sea_level_m, run);
  const double threshold = std::max(2.0, plan.channel_m2 / (frame.cell_m * frame.cell_m));
  return length_of(find_links(ridges.directions, ridges.cells, threshold, &ridges.land, run), frame);
}

/// The terrain with something in its unknown cells, so that slopes and windows beside them are not cliffs; empty if all
/// are known.
HeightField fill_unknown(const HeightField& terrain, const RunContext& run) {
  if (std::find(terrain.cells().begin(), terrain.cells().end(), geom::kUnknownGround) == terrain.cells().end())
    return {};
  HeightField filled = terrain;
  geom::forget_unknown(filled);
  geom::fill_voids(filled, run);
  return filled;
}

Distribution distribution_on(const HeightField& terrain, float sea, float origin, const ScalarField& field,
                             const RunContext& run) {
  const auto is_land = [&](int64_t i) { return terrain.data()[i] > sea; };
  return gather(
      Tally(origin, false), terrain.frame().cells(), is_land, [&](int64_t i) { return field.data()[i]; }, run);
}

/// What is found around each cell. One field at a time: with what follows they would be the peak of memory.
void survey_surface(const HeightField& terrain, float sea, int radius, Survey& out, const RunContext& run) {
  const HeightField filled = fill_unknown(terrain, run);
  const HeightField& surface = filled.empty() ? terrain : filled;
  const auto distribution = [&](const ScalarField& field) { return distribution_on(terrain, sea, 0.0F, field, run); };
  out.slope = distribution(geom::slope_deg(surface, run));
  out.aspect = aspects(terrain, surface, sea, run);
  out.curvature = distribution(geom::curvature(surface, geom::Curvature::mean, run));
  out.relief = distribution(local_relief(surface, radius, run));
}

}  // namespace

Land find_land(const HeightField& terrain, float sea_level_m) {
  Land land{terrain.cell_m() * terrain.cell_m(), terrain.frame().cells()};
  for (const float z : terrain.cells()) {
    if (z <= sea_level_m) continue;
    land.low_m = land.cells == 0 ? z : std::min(land.low_m, z);
    land.high_m = land.cells == 0 ? z : std::max(land.high_m, z);
    ++land.cells;
  }
  return land;
}

Survey survey(const HeightField& terrain, const SurveyPlan& plan, const RunContext& run) {
  const float sea = plan.sea_level_m;
  const GridFrame& frame = terrain.frame();
  const int radius =
      std::max(1, static_cast<int>(std::lround(0.5 * std::min(plan.relief_window_m, 1e7) / frame.cell_m)));
  const Land land = find_land(terrain, sea);
  Survey out;
  out.cell_m = frame.cell_m;
  out.relief_window_m = (2 * radius + 1) * frame.cell_m;
  if (land.cells == 0) return out;
  out.land_m2 = static_cast<double>(land.cells) * land.cell_m2;
  out.elevation = distribution_on(terrain, sea, land.low_m, terrain, run);
  survey_surface(terrain, sea, radius, out, run);
  survey_rivers(terrain, plan, out, run);
  out.ridge_m = ridge_length(terrain, plan, run);
  out.peaks = find_peaks(terrain, sea, plan.min_prominence_m, run);
  out.unevenness = unevenness_of(terrain, sea, run);
  return out;
}

}  // namespace seamount::hydrology

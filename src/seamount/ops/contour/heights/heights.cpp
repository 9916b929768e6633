#include "seamount/ops/contour/heights/heights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/ops/contour/heights/node_heights.h"

namespace seamount::contour {
namespace {

constexpr int kMeasuredBins = 4096;
constexpr double kRelief = 1.0 / 12.0;  ///< of the land's width

void check_grown(const Tin& tin) {
  const size_t nodes = tin.nodes.size();
  if (tin.regions.empty() || tin.region.size() != nodes || tin.rank.size() != nodes) {
    throw IncompatibleInputs("tin: it has no regions and ranks to take heights from; make it with contour.grow");
  }
  if (!tin.bed_m.empty() && tin.bed_m.size() != nodes)
    throw IncompatibleInputs("tin: a river bed for each node or none");
  for (size_t i = 0; i < tin.regions.size(); ++i) {
    if (tin.regions[i].parent >= static_cast<int>(i))
      throw IncompatibleInputs("tin: a region stands before its parent");
  }
  for (const int32_t region : tin.region) {
    if (region < Tin::kOutside || region >= static_cast<int32_t>(tin.regions.size())) {
      throw IncompatibleInputs(fmt::format("tin: a node in region {}, of {}", region, tin.regions.size()));
    }
  }
}

/// The width of a square as large as the land.
double land_width(const Tin& tin) {
  double twice = 0.0;
  for (const auto& [a, b, c] : tin.triangles) {
    const auto node = [&](int32_t i) { return static_cast<size_t>(i); };
    if (tin.region[node(a)] < 0 || tin.region[node(b)] < 0 || tin.region[node(c)] < 0) continue;
    twice += cross(tin.nodes[node(b)] - tin.nodes[node(a)], tin.nodes[node(c)] - tin.nodes[node(a)]);
  }
  return std::sqrt(0.5 * std::max(twice, 0.0));
}

HeightDistribution make_distribution(const Tin& tin, const HeightField* terrain, const HeightsParams& params) {
  std::vector<std::string> given;
  if (!params.histogram.empty()) given.emplace_back("histogram");
  if (!params.density.knots.empty()) given.emplace_back("density");
  if (terrain != nullptr) given.emplace_back("the input 'terrain'");
  if (given.size() > 1) {
    throw InvalidArgument(given[0], "given together with " + given[1] + "; heights follow one distribution");
  }
  MeasuredHeights measured;
  double low = 0.0;
  double high = 0.0;
  if (terrain != nullptr) {
    measured = measure_heights(*terrain, params.measure_above_m.value_or(-HUGE_VAL), kMeasuredBins);
    low = measured.low_m;
    high = measured.high_m;
  } else {
    bool any = false;
    for (const TinRegion& region : tin.regions) {
      if (!region.height_m) continue;
      low = any ? std::min(low, *region.height_m) : *region.height_m;
      high = any ? std::max(high, *region.height_m) : *region.height_m;
      any = true;
    }
    if (params.min_m) high = std::max(high, *params.min_m);
    high += std::max(kRelief * land_width(tin), 1.0);
    for (const TinRegion& region : tin.regions) high = std::max(high, region.peak_m.value_or(high));
  }
  low = params.min_m.value_or(low);
  high = params.max_m.value_or(high);
  if (!(low < high)) {
    throw InvalidArgument("max_m", fmt::format("the highest height {} m is not above the lowest, {} m",
                                               format_number(high), format_number(low)));
  }
  if (terrain != nullptr) return HeightDistribution::from_bins(measured.bins, low, high, "terrain");
  if (!params.histogram.empty()) return HeightDistribution::from_bins(params.histogram, low, high, "histogram");
  if (!params.density.knots.empty()) return HeightDistribution::from_density(params.density, low, high, "density");
  return HeightDistribution::of_landform(params.landform, low, high);
}

std::vector<int64_t> count_nodes(const Tin& tin) {
  std::vector<int64_t> nodes(tin.regions.size(), 0);
  for (const int32_t region : tin.region) {
    if (region >= 0) ++nodes[static_cast<size_t>(region)];
  }
  return nodes;
}

void apply(const Limits& limits, const Tin& tin, std::vector<double>& height) {
  for (size_t node = 0; node < height.size(); ++node) {
    if (tin.region[node] >= 0) height[node] = std::max(limits.floor[node], std::min(height[node], limits.cap[node]));
  }
}

}  // namespace

Tin heights(Tin tin, const HeightField* terrain, const HeightsParams& params, const RunContext& run) {
  check_params(params);
  check_grown(tin);
  run.check_cancelled();
  const HeightDistribution distribution = make_distribution(tin, terrain, params);
  const std::vector<RegionBand> bands = height_bands(tin.regions, count_nodes(tin), distribution, params);
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size(), run);
  run.report(0.2);
  const std::vector<Shore> shores = find_shores(tin, graph, run);
  Limits limits = find_limits(tin, bands, shores);
  run.check_cancelled();
  limit_rivers(tin, graph, limits);
  std::vector<double> height = band_heights(tin, bands, shores, distribution, params, run);
  stand_on_rivers(tin, graph, bands, height, run);
  apply(limits, tin, height);
  run.check_cancelled();
  run.report(0.5);
  std::vector<float> beside(tin.nodes.size(), -1.0F);
  if (params.outlines == Outlines::follow) {
    follow_outlines(tin, graph, bands, shores, height, beside, run.part(0.5, 0.7));
    apply(limits, tin, height);
  }
  run.check_cancelled();
  if (params.spikes == Spikes::cut) cut_spikes(tin, graph, limits, height, run);
  const double slope = std::tan(params.shore_slope_deg * std::numbers::pi / 180.0);
  fall_outside(tin, graph, bands, shores, beside, slope, land_width(tin), height, run);
  fill_behind_rivers(tin, graph, limits, height, run);
  tin.height_m = drain(tin, graph, bands, limits, std::move(height), run);
  fill_pits(tin, graph, run);
  run.report(1.0);
  return tin;
}

}  // namespace seamount::contour

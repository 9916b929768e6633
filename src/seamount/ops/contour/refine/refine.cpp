#include "seamount/ops/contour/refine/refine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/inputs.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/heights/heights.h"
#include "seamount/ops/contour/refine/held_contours.h"
#include "seamount/ops/contour/refine/refine_ground.h"
#include "seamount/ops/contour/refine/refine_regions.h"

namespace seamount::contour {
namespace {

constexpr double kFeature = 12.0;  ///< the noise's largest forms, in spacings of the network that is refined
constexpr int kBins = 1024;        ///< of the distribution of heights
constexpr double kMinPeak = 0.1;   ///< of a summit that no sample shows, in steps between levels

size_t at(int32_t i) { return static_cast<size_t>(i); }

double mean_side(const Ring& ring) { return geom::ring_length(ring) / static_cast<double>(ring.size()); }

/// Summits and basin floors keep the heights that the coarse ground has in them.
void set_peaks(Tin& tin, const CoarseGround& ground, const std::vector<int32_t>& region) {
  const size_t count = tin.regions.size();
  std::vector<float> low(count, std::numeric_limits<float>::max()), high(count, std::numeric_limits<float>::lowest());
  for (size_t i = 0; i < region.size(); ++i) {
    if (region[i] < 0) continue;
    low[at(region[i])] = std::min(low[at(region[i])], ground.heights[i]);
    high[at(region[i])] = std::max(high[at(region[i])], ground.heights[i]);
  }
  std::vector<char> ends(count, 1);
  for (const TinRegion& r : tin.regions) {
    if (r.parent >= 0 && r.basin == tin.regions[at(r.parent)].basin) ends[at(r.parent)] = 0;
  }
  std::set<double> levels;
  for (const TinRegion& r : tin.regions) levels.insert(*r.height_m);
  const double least = kMinPeak * (ground.high_m - ground.low_m) / static_cast<double>(levels.size() + 1);
  for (size_t i = 0; i < count; ++i) {
    TinRegion& r = tin.regions[i];
    r.peak_m.reset();
    if (ends[i] == 0) continue;
    const double found = static_cast<double>(r.basin ? low[i] : high[i]);
    const bool beyond = r.basin ? found < *r.height_m : found > *r.height_m;
    r.peak_m = beyond ? found : *r.height_m + (r.basin ? -least : least);
  }
}

/// Heights as the coarse ground has them between the same contours.
HeightsParams heights_params(const CoarseGround& ground, const Tin& tin, const std::vector<int32_t>& region,
                             const RefineParams& params) {
  HeightsParams heights;
  double low = ground.low_m, high = ground.high_m;
  for (const TinRegion& r : tin.regions) {
    low = std::min({low, *r.height_m, r.peak_m.value_or(low)});
    high = std::max({high, *r.height_m, r.peak_m.value_or(high)});
  }
  heights.min_m = low;
  heights.max_m = high + 1e-3 * (high - low);
  heights.histogram.assign(kBins, 0.0);
  for (size_t i = 0; i < region.size(); ++i) {
    if (region[i] < 0) continue;
    const double share = (static_cast<double>(ground.heights[i]) - low) / (*heights.max_m - low);
    heights.histogram[static_cast<size_t>(std::clamp(static_cast<int>(share * kBins), 0, kBins - 1))] += 1.0;
  }
  heights.summits = Summits::equal;
  heights.spikes = Spikes::keep;  // the contours around hold the ground
  heights.shore_slope_deg = params.shore_slope_deg;
  return heights;
}

double of_pass(const std::vector<double>& values, int pass, double otherwise) {
  if (values.empty()) return otherwise;
  return values[std::min(static_cast<size_t>(pass), values.size() - 1)];
}

class Refining {
 public:
  Refining(const RefineInputs& inputs, const RefineParams& params, double coarse_m, double final_m, Seed seed,
           const RunContext& run)
      : inputs_(inputs), params_(params), coarse_(coarse_m), final_(final_m), seed_(seed), run_(run) {}

  /// `found`: contours to hold besides the outlines.
  Tin pass(int number, CoarseGround& ground, const std::vector<Contour>& found) const {
    const RunContext run = run_.part(static_cast<double>(number) / params_.passes, (number + 1.0) / params_.passes);
    const Seed seed = seed_.derive("pass", static_cast<uint64_t>(number));
    const double share = (number + 1.0) / params_.passes;
    GrowParams grow;
    grow.spacing_m = number + 1 == params_.passes ? final_ : coarse_ * std::pow(final_ / coarse_, share);
    grow.probability = params_.probability;
    grow.feature_m = of_pass(params_.feature_m, number, kFeature * ground.spacing_m);
    grow.exponent = of_pass(params_.exponent, number, 2.0);
    grow.octaves = params_.octaves;
    grow.rivers = params_.rivers;
    const RegionTree tree = hold_contours(ground.outlines, found, ground.frame,
                                          {ground.spacing_m, final_, params_.roughness}, seed.derive("detail"), run);
    Tin tin = scatter_nodes(tree, ground.frame, inputs_.rivers, grow, seed, run.part(0.2, 0.6));
    close_waters(tin, run);
    fit_regions(tin, run);
    const std::vector<int32_t> region = regions_at(regions_of(tin), ground.places, run);
    run.check_cancelled();
    set_peaks(tin, ground, region);
    grow_nodes(tin, inputs_.probability, grow, seed, run.part(0.6, 0.8));
    run.check_cancelled();
    const HeightsParams distribution = heights_params(ground, tin, region, params_);
    tin = heights(std::move(tin), nullptr, distribution, run.part(0.8, 1.0));
    return tin;
  }

 private:
  const RefineInputs& inputs_;
  const RefineParams& params_;
  double coarse_, final_;
  Seed seed_;
  const RunContext& run_;
};

/// `least_m`: what it is not finer than by itself.
double final_spacing(const RefineParams& params, const CoarseGround& ground, double least_m) {
  const double coarse = ground.spacing_m;
  const double fine = params.spacing_m.value_or(std::max(coarse / std::exp2(params.passes), least_m));
  if (!(fine < coarse)) {
    throw InvalidArgument("spacing_m", fmt::format("{} is not finer than what there is, a spacing of {} m",
                                                   format_number(fine), format_number(std::round(coarse * 10) / 10)));
  }
  RegionTree tree;
  for (const HeldOutline& outline : ground.outlines) tree.regions.push_back(outline.region);
  check_spacing(tree, ground.frame, fine);
  return fine;
}

/// What is coarser than the network to come is given detail like contours of its triangles.
void set_exact(CoarseGround& ground, double final_m) {
  for (HeldOutline& outline : ground.outlines) outline.exact = mean_side(outline.region.outline) <= final_m;
}

/// What the next pass refines, and from which contours it takes its levels.
CoarseGround next_ground(const Tin& tin, std::vector<double> levels) {
  CoarseGround ground = ground_of(tin);
  std::sort(levels.begin(), levels.end());
  ground.levels = std::move(levels);
  return ground;
}

}  // namespace

Tin refine(const Tin& coarse, const RefineInputs& inputs, const RefineParams& params, Seed seed,
           const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  CoarseGround ground = ground_of(coarse);
  const double fine = final_spacing(params, ground, 0.0);
  set_exact(ground, fine);
  const Refining refining(inputs, params, ground.spacing_m, fine, seed, run);
  Tin tin;
  for (int pass = 0; pass < params.passes; ++pass) {
    std::vector<double> levels = new_levels(ground, pass == 0 ? coarse : tin, params.contours, run);
    const std::vector<Contour> found = geom::march_triangles(pass == 0 ? coarse : tin, levels, run);
    tin = refining.pass(pass, ground, found);
    levels.insert(levels.end(), ground.levels.begin(), ground.levels.end());
    if (pass + 1 < params.passes) ground = next_ground(tin, std::move(levels));
  }
  return tin;
}

Tin refine(const ContourSet& coarse, const RefineInputs& inputs, const RefineParams& params, Seed seed,
           const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  CoarseGround ground = ground_of(coarse, run);
  const double fine = final_spacing(params, ground, 0.8 * coarse.frame.cell_m);
  set_exact(ground, fine);
  const Refining refining(inputs, params, ground.spacing_m, fine, seed, run);
  Tin tin = refining.pass(0, ground, {});
  std::vector<double> levels = ground.levels;
  for (int pass = 1; pass < params.passes; ++pass) {
    ground = next_ground(tin, std::move(levels));
    levels = new_levels(ground, tin, params.contours, run);
    tin = refining.pass(pass, ground, geom::march_triangles(tin, levels, run));
    levels.insert(levels.end(), ground.levels.begin(), ground.levels.end());
  }
  return tin;
}

Tin refine(const Tin* tin, const ContourSet* contours, const RefineInputs& inputs, const RefineParams& params,
           Seed seed, const RunContext& run) {
  require_one("tin", tin != nullptr, "contours", contours != nullptr);
  return tin != nullptr ? refine(*tin, inputs, params, seed, run) : refine(*contours, inputs, params, seed, run);
}

}  // namespace seamount::contour

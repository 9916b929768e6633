#include "seamount/train/island_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "seamount/geom/scalar/curve.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/island/archipelago.h"
#include "seamount/ops/island/build.h"
#include "seamount/ops/island/coral.h"
#include "seamount/ops/island/wind.h"

namespace seamount::train {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostOverlap = 0.1;
constexpr int kAngles = 128;
constexpr double kNoLand_m = 10.0;  // outlines of mountain and coast within this are a point
constexpr size_t kCoastOutline = 1;

GridFrame sample_frame(const IslandSetParams& params) {
  return GridFrame::centred(params.size, params.size, params.width_m / params.size);
}

/// The region maps of fig. 1.37, and what is left of islands that have sunk.
enum class Form { round, elongated, remnant, atoll };

Form draw_form(Rng& rng) {
  const double u = rng.uniform();
  if (u < 0.5) return Form::round;
  if (u < 0.75) return Form::elongated;
  return u < 0.9 ? Form::remnant : Form::atoll;
}

/// Mean radii of the five outlines. A remnant is a small island in a wide lagoon, an atoll has no land at all.
std::array<double, 5> draw_mean_radii(Form form, double width_m, Rng& rng) {
  double coast = width_m * rng.uniform(0.1, 0.24);
  double lagoon = width_m * rng.uniform(0.015, 0.07);
  double beach = coast * rng.uniform(0.02, 0.07);
  const double left = rng.uniform(0.25, 0.55);
  if (form == Form::remnant || form == Form::atoll) {
    const double remains = form == Form::atoll ? 2.0 : left * coast;
    lagoon += coast - remains;
    coast = remains;
    beach = std::min(beach, 0.5 * coast);
  }
  const double reef = width_m * rng.uniform(0.02, 0.06);
  const double slope = width_m * rng.uniform(0.05, 0.14);
  return {coast - beach, coast, coast + lagoon, coast + lagoon + reef, coast + lagoon + reef + slope};
}

/// Radius of an ellipse of unit area over the angle from its long axis.
double ellipse(double aspect, double angle) {
  return 1.0 / std::sqrt(std::pow(std::cos(angle), 2) / aspect + std::pow(std::sin(angle), 2) * aspect);
}

/// eq. 1.16: circles (and ellipses) of random radius with noise, ordered with a gap at every angle.
std::vector<PolarOutline> draw_outlines(Form form, double width_m, Rng& rng, Seed seed) {
  const std::array<double, 5> mean = draw_mean_radii(form, width_m, rng);
  const double size = mean[form == Form::atoll || form == Form::remnant ? 2 : 1];
  const double aspect = form == Form::elongated ? rng.uniform(1.8, 3.2) : rng.uniform(1.0, 1.35);
  const double shared = size * rng.uniform(0.1, form == Form::round ? 0.8 : 0.4);
  const double bearing = rng.uniform(0.0, 2 * kPi);
  const double own = rng.uniform(0.1, 0.7);
  const double frequency = rng.uniform(1.5, 4.0);
  std::vector<PolarOutline> outlines(5);
  for (int a = 0; a < kAngles; ++a) {
    const double angle = 2 * kPi * a / kAngles;
    const double common = shared * geom::fbm_circle(seed.derive("outline.shared"), angle, frequency, 5) +
                          size * (ellipse(aspect, angle - bearing) - 1.0);
    double inner = 0;
    for (size_t i = 0; i < 5; ++i) {
      const double width = mean[i] - (i == 0 ? 0 : mean[i - 1]);
      const double share = i == 4 ? 0.6 : std::min(1.0, mean[i] / size);  // what is left of the land is rounder
      const double noise = common * share + own * std::min(width, 0.3 * size) *
                                                geom::fbm_circle(seed.derive("outline", i), angle, 2 * frequency, 4);
      const bool nothing = form == Form::atoll && i < 2;
      const double gap = nothing ? 0.5 : std::max(0.35 * width, 1e-3 * width_m);
      inner = std::max(mean[i] + (nothing ? 0.0 : noise), inner + gap);
      outlines[i].radii_m.push_back(std::round(inner * 100) / 100);
    }
  }
  return outlines;
}

double mean_radius(const PolarOutline& outline) {
  double sum = 0.0;
  for (const double r : outline.radii_m) sum += r;
  return sum / static_cast<double>(outline.radii_m.size());
}

/// Without land there is no summit: what lies within the lagoon is its floor.
void sink_land(Curve& profile) {
  double floor = 0.0;
  for (const Knot& knot : profile.knots) {
    if (knot.x >= 2.0 && knot.x <= 3.0) floor = std::min(floor, knot.y);
  }
  for (Knot& knot : profile.knots) knot.y = knot.x < 2.5 ? floor : knot.y;
}

std::vector<Stroke> draw_strokes(double width_m, Rng& rng) {
  std::vector<Stroke> strokes(static_cast<size_t>(rng.integer(0, 6)));
  for (Stroke& stroke : strokes) {
    const int points = rng.integer(2, 5);
    for (int k = 0; k < points; ++k) {
      const double x = rng.uniform(-0.5, 0.5) * width_m;
      const double y = rng.uniform(-0.5, 0.5) * width_m;
      stroke.points.push_back({std::round(x), std::round(y)});
    }
    stroke.width_m = std::round(width_m * rng.uniform(0.02, 0.09));
    stroke.strength_m = std::round(stroke.width_m * rng.uniform(0.2, 0.9));
  }
  return strokes;
}

IslandDraw draw_island(const IslandSetParams& params, uint64_t index, Seed seed) {
  const Seed own = seed.derive("train.island", index);
  Rng rng(own);
  IslandDraw island;
  island.index = static_cast<double>(index);
  const Form form = draw_form(rng);
  island.outlines = draw_outlines(form, params.width_m, rng, own);
  double peak = rng.uniform(0.2, 0.5) * params.high_m;
  if (form == Form::remnant) peak = std::min(peak, 0.5 * mean_radius(island.outlines[kCoastOutline]));
  const double floor = rng.uniform(0.35, 0.85) * params.low_m;
  const double bow = rng.uniform(0.7, 1.5);
  Curve profile;
  for (const double x : {0.0, 0.15, 0.35, 0.6, 0.8})
    profile.knots.push_back({x, 8 + (peak - 8) * std::pow(1 - x, bow)});
  for (const auto& [x, y] : {std::pair{1.0, 6.0}, {2.0, 0.0}, {2.4, -3.0}, {3.0, -6.0}, {3.8, -14.0}, {4.05, -30.0}})
    profile.knots.push_back({x, y});
  for (const auto& [x, share] : {std::pair{4.3, 0.45}, {4.65, 0.85}, {5.0, 1.0}})
    profile.knots.push_back({x, std::min(share * floor, profile.knots.back().y - 1)});
  island.profile = times_noise(profile, 0.25, params.low_m, params.high_m, own.derive("profile"));
  // The sea floor beyond the last outline is the lowest place: what lies around an island joins it without a step.
  for (size_t i = 41; i < island.profile.knots.size(); ++i) {
    island.profile.knots[i].y = std::min(island.profile.knots[i].y, island.profile.knots[i - 1].y);
  }
  if (form == Form::atoll) sink_land(island.profile);
  island.resistance = times_noise(island::WindParams().resistance, 0.5, 0.0, 1.0, own.derive("resistance"));
  island.strokes = draw_strokes(params.width_m, rng);
  if (rng.chance(0.7)) {
    island.radial_count = 2 * rng.integer(4, 18);
    island.radial_width_m = std::round(params.width_m * rng.uniform(0.006, 0.014));
    island.radial_strength_m = std::round(island.radial_width_m * rng.uniform(0.3, 0.9));
  }
  island.relief = std::round(100 * rng.uniform(0.2, 1.0)) / 100;
  island.valley_spacing_m = std::round(params.width_m * rng.uniform(0.03, 0.08));
  return island;
}

/// An island that will be scaled down is made with as few cells as it is going to cover.
GridFrame island_frame(const IslandSetParams& params, double scale) {
  const int size = std::clamp(static_cast<int>(std::ceil(scale * params.size)), 1, params.size);
  return GridFrame::centred(size, size, params.width_m / size);
}

IslandPair make_island(const IslandSetParams& params, const IslandDraw& draw, double subsidence, double scale,
                       Seed seed, const RunContext& run) {
  const Seed own = seed.derive("train.island.noise", static_cast<uint64_t>(draw.index));
  const GridFrame frame = island_frame(params, scale);
  const island::Plan plan = island::plan_from_polar(draw.outlines, {}, {});
  island::BuildParams build;
  build.profile = draw.profile;
  build.relief = draw.relief;
  build.detail.valley_spacing_m = draw.valley_spacing_m;
  island::Island isle = island::build(plan, build, frame, own, run);
  for (Region& label : isle.labels.cells()) {  // an atoll's middle is a point that a cell may hit
    if (draw.outlines[kCoastOutline].radii_m[0] < kNoLand_m) label = std::max(label, Region::lagoon);
  }
  island::WindParams wind;
  wind.strokes = draw.strokes;
  wind.resistance = draw.resistance;
  wind.radial_count = draw.radial_count;
  wind.radial_width_m = draw.radial_width_m;
  wind.radial_strength_m = draw.radial_strength_m;
  const island::Warped warped = island::wind(isle.terrain, &isle.labels, &isle.coordinate, wind, own, run);
  // What the labels cannot show, the network cannot know: no passes and no islets; labels stay those before subsidence.
  island::CoralParams coral;
  coral.subsidence = subsidence;
  coral.exposure = 0;
  coral.passes = 0;
  coral.islets = 0;
  coral.relabel = false;
  island::Reefed reefed = island::coral(warped.terrain, warped.labels, &warped.coordinate, coral, own, run);
  return {std::move(reefed.terrain), std::move(reefed.labels)};
}

template <class T>
void mirror(Grid<T>& grid) {
  for (int y = 0; y < grid.height(); ++y) std::reverse(grid.row(y).begin(), grid.row(y).end());
}

Augmentation draw_augmentation(const IslandSetParams& params, int islands, Rng& rng) {
  Augmentation a;
  for (int i = 0; i < islands; ++i) {
    const double spread = islands > 1 ? 0.32 * params.width_m : 0.0;
    const double x = rng.uniform(-1, 1) * spread;
    const double y = rng.uniform(-1, 1) * spread;
    a.places.push_back({std::round(x), std::round(y)});
    a.turns_deg.push_back(std::round(10 * rng.uniform(-180, 180)) / 10);
    a.scales.push_back(std::round(1000 * (islands > 1 ? rng.uniform(0.3, 0.65) : rng.uniform(0.6, 1.15))) / 1000);
  }
  a.flip = rng.chance(0.5);
  if (rng.chance(0.75)) {
    a.shift_x = rng.integer(0, params.size - 1);
    a.shift_y = rng.integer(0, params.size - 1);
  }
  return a;
}

}  // namespace

Curve times_noise(const Curve& curve, double amplitude, double low, double high, Seed seed) {
  const geom::CurveFunction base(curve);
  Curve out;
  for (int i = 0; i <= 50; ++i) {
    const double x = 0.1 * i;
    const double y = base(x) * (1.0 + amplitude * geom::fbm1(seed, 1.3 * x, 2));
    out.knots.push_back({x, std::round(std::clamp(y, low, high) * 1000) / 1000});
  }
  return out;
}

double overlap(const LabelMap& a, const LabelMap& b) {
  int64_t both = 0, either = 0;
  for (size_t c = 0; c < a.size(); ++c) {
    const bool in_a = a.cells()[c] != Region::abyss, in_b = b.cells()[c] != Region::abyss;
    both += in_a && in_b ? 1 : 0;
    either += in_a || in_b ? 1 : 0;
  }
  return either == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(either);
}

IslandSample draw_island_sample(const IslandSetParams& params, uint64_t index, Seed seed) {
  check_params(params);
  const uint64_t island = index / static_cast<uint64_t>(params.levels);
  const auto level = static_cast<double>(index % static_cast<uint64_t>(params.levels));
  Rng rng(seed.derive("train.sample", index));
  IslandSample sample;
  sample.index = index;
  sample.subsidence = std::round(1000 * (level + rng.uniform()) / params.levels) / 1000;
  const int islands = rng.chance(params.several) ? rng.integer(2, 4) : 1;
  for (int i = 0; i < islands; ++i) {
    // The other islands of a sample are islands of their own, or copies of the first.
    const bool copy = i > 0 && rng.chance(0.5);
    const uint64_t other = (uint64_t{1} << 40) + index * 8 + static_cast<uint64_t>(i);
    sample.islands.push_back(copy ? sample.islands.front() : draw_island(params, i == 0 ? island : other, seed));
  }
  sample.augmentation = draw_augmentation(params, islands, rng);
  return sample;
}

IslandPair make_island_pair(const IslandSetParams& params, IslandSample& sample, Seed seed, const RunContext& run) {
  const GridFrame frame = sample_frame(params);
  std::vector<IslandPair> islands;
  for (size_t i = 0; i < sample.islands.size(); ++i) {
    islands.push_back(
        make_island(params, sample.islands[i], sample.subsidence, sample.augmentation.scales[i], seed, run));
    if (sample.augmentation.flip) {
      mirror(islands.back().terrain);
      mirror(islands.back().labels);
    }
  }
  std::vector<LabelMap> placed;
  std::vector<size_t> kept;
  const Augmentation all = sample.augmentation;
  for (size_t i = 0; i < islands.size(); ++i) {
    if (islands.size() > 1) {
      LabelMap labels =
          island::placed_labels(islands[i].labels, all.places[i], all.turns_deg[i], all.scales[i], frame, run);
      const bool clash = std::any_of(placed.begin(), placed.end(),
                                     [&](const LabelMap& other) { return overlap(labels, other) > kMostOverlap; });
      if (clash) continue;
      placed.push_back(std::move(labels));
    }
    kept.push_back(i);
  }
  island::ArchipelagoParams together;
  std::vector<island::Member> members;
  std::vector<IslandDraw> draws;
  for (const size_t i : kept) {
    members.push_back({&islands[i].terrain, &islands[i].labels});
    draws.push_back(sample.islands[i]);
    together.places.push_back(all.places[i]);
    together.turns_deg.push_back(all.turns_deg[i]);
    together.scales.push_back(all.scales[i]);
  }
  island::Archipelago sea = island::archipelago(members, together, frame, run);
  sample.islands = std::move(draws);
  sample.augmentation.places = together.places;
  sample.augmentation.turns_deg = together.turns_deg;
  sample.augmentation.scales = together.scales;
  if (all.shift_x == 0 && all.shift_y == 0) return {std::move(sea.terrain), std::move(sea.labels)};
  return {wrapped(sea.terrain, all.shift_x, all.shift_y), wrapped(sea.labels, all.shift_x, all.shift_y)};
}

}  // namespace seamount::train

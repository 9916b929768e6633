#include "seamount/ops/island/build.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/breach.h"
#include "seamount/geom/water/gullies.h"
#include "seamount/geom/water/raise_pits.h"
#include "seamount/ops/island/coast_room.h"
#include "seamount/ops/island/coordinate.h"
#include "seamount/ops/island/craters.h"
#include "seamount/ops/island/peak_heights.h"
#include "seamount/ops/island/summits.h"

namespace seamount::island {
namespace {

constexpr int kReliefSide = 2048;
constexpr int kValleySide = 512;       ///< nodes a side where broad valleys are made to drain
constexpr double kValleySlope = 0.01;  ///< least fall of their floors
constexpr double kCarving = 1.6;       ///< strength of gullies at relief 1

/// Everything that a row of the island is made from.
struct Making {
  RegionCoordinate coordinate;
  geom::CurveTable profile;
  geom::Fbm coast_detail;
  double coast_detail_m;
  ScalarField coast_room;  ///< for that of areas
  geom::Fbm noise;
  float noise_m;
  double radius;  ///< of the largest lobe
  double peak;
  Seed seed;
};

/// Noise fades out where the height is 0, so the coast stays where it is, and towards the sea floor, which is flat.
SEAMOUNT_VECTORISED void add_noise(const float* __restrict noise, const float* __restrict coordinate, float noise_m,
                                   float* __restrict height, int count) {
  const float per_height = 1.0F / (noise_m > 4.0F ? 3.0F * noise_m : 12.0F);
  for (int i = 0; i < count; ++i) {
    const float z = height[i];
    const float share = (z < 0 ? -z : z) * per_height;
    const float above_floor = 2.0F * (5.0F - coordinate[i]);
    const float fade = share < above_floor ? share : above_floor;
    height[i] = z + noise_m * noise[i] * (fade < 1.0F ? fade : 1.0F);
  }
}

SEAMOUNT_VECTORISED void label_row(const float* __restrict coordinate, uint8_t* __restrict label, int count) {
  for (int i = 0; i < count; ++i) {
    const float x = coordinate[i] < 4.0F ? coordinate[i] : 4.0F;
    label[i] = static_cast<uint8_t>(static_cast<int32_t>(x));
  }
}

/// How deep gullies may cut: fully on land above the beach, less on the slopes of the deep, not in lagoon and reef.
SEAMOUNT_VECTORISED void gully_strength_row(const float* coordinate, const float* height, float land_scale,
                                            float* strength, int count) {
  for (int i = 0; i < count; ++i) {
    const float x = coordinate[i];
    const float on_land = height[i] > 0.0F ? height[i] * land_scale : 0.0F;
    const float under_water = x > 4.0F && x < 5.0F ? 0.4F * (x - 4.0F) : 0.0F;
    const float s = x < 2.0F ? on_land : (under_water < 0.16F ? under_water : 0.16F);
    strength[i] = s < 1.0F ? s : 1.0F;
  }
}

/// Detail of the coast stays within the room that it has.
SEAMOUNT_VECTORISED void bound_by_room(const float* __restrict room, int count, float* __restrict shift) {
  for (int i = 0; i < count; ++i) {
    const float size = shift[i] < 0.0F ? -shift[i] : shift[i];
    shift[i] = room[i] > 0.0F ? shift[i] * room[i] / (room[i] + size) : 0.0F;
  }
}

void coordinate_rows(const Making& making, const GridFrame& frame, ScalarField& out, const RunContext& run) {
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> shift(static_cast<size_t>(frame.width), 0.0F), room(shift.size());
    for (int y = begin; y < end; ++y) {
      if (making.coast_detail_m > 0) {
        std::fill(shift.begin(), shift.end(), 0.0F);
        geom::fbm_add_row(making.seed.derive("island.coast_detail"), making.coast_detail, frame.x(0), frame.cell_m,
                          frame.y(y), shift, static_cast<float>(making.coast_detail_m));
        if (!making.coast_room.empty()) {
          geom::RowUpsampler(making.coast_room).read(frame.x(0), frame.cell_m, frame.y(y), room);
          bound_by_room(room.data(), frame.width, shift.data());
        }
      }
      making.coordinate.row(frame.x(0), frame.cell_m, frame.y(y), shift, out.row(y));
    }
  });
}

/// From the first to the last cell of a row that lies within an outline.
struct Part {
  size_t first, count;
};

Part within(std::span<const float> coordinate, float outline) {
  size_t first = 0, last = coordinate.size();
  while (first < last && coordinate[first] >= outline) ++first;
  while (last > first && coordinate[last - 1] >= outline) --last;
  return {first, last - first};
}

/// Land rises unevenly by broad noise: never higher than the profile, and as high as it on the highest summit.
SEAMOUNT_VECTORISED void lower_by_massif(const float* __restrict noise, const float* __restrict coordinate,
                                         float amount, float* __restrict height, int count) {
  const float bound = 1.2F * amount / (1.0F + 0.4F * amount);
  for (int i = 0; i < count; ++i) {
    const float low = 0.42F - 1.2F * noise[i];
    const float share = low > 0.0F ? (low < 1.0F ? low : 1.0F) : 0.0F;
    const float away = coordinate[i] * 2.2F;
    const float fade = away < 1.0F ? away * away * (3.0F - 2.0F * away) : 1.0F;
    height[i] = height[i] > 0.0F ? height[i] * (1.0F - bound * share * fade) : height[i];
  }
}

/// Valleys end at the sea, crests stay mountains and the sea stays water: what was cut and raised is bounded by a share
/// of the height or depth there, softly, so that no parameter digs below the coast.
SEAMOUNT_VECTORISED void bound_by_height(const float* __restrict before, float* __restrict height, int count) {
  for (int i = 0; i < count; ++i) {
    const float size = before[i] < 0.0F ? -before[i] : before[i];
    const float base = size > 1e-3F ? size : 1e-3F;
    const float change = (height[i] - before[i]) / base;
    const float cut = change < 0.0F ? -change : 0.0F;
    const float raised = change > 0.0F ? change : 0.0F;
    const float per_raised = before[i] > 0.0F ? 4.0F : 2.0F;  // 1 / the most that is raised
    const float per_cut = before[i] > 0.0F ? 1.25F : 0.0F;
    height[i] = before[i] + base * (raised / (1.0F + raised * per_raised) - cut / (1.0F + cut * per_cut));
  }
}

/// The profile's heights, raised unevenly.
void massif_rows(const Making& making, const ScalarField& coordinate, double amount, double valley_spacing,
                 HeightField& height, const RunContext& run) {
  const geom::Fbm massif{.wavelength_m = 3.2 * valley_spacing, .octaves = 3, .gain = 0.45, .cell_m = height.cell_m()};
  parallel_rows(run, height.width(), height.height(), [&](int begin, int end) {
    std::vector<float> noise(static_cast<size_t>(height.width()), 0.0F);
    for (int y = begin; y < end; ++y) {
      making.profile.evaluate(coordinate.row(y), height.row(y));
      const Part land = within(coordinate.row(y), 2.0F);
      if (amount <= 0 || land.count == 0) continue;
      geom::fbm_row(making.seed.derive("island.massif"), massif, height.frame().x(static_cast<double>(land.first)),
                    height.cell_m(), height.frame().y(y), {noise.data(), land.count});
      lower_by_massif(noise.data(), &coordinate.row(y)[land.first], static_cast<float>(amount),
                      &height.row(y)[land.first], static_cast<int>(land.count));
    }
  });
}

/// Heights of the profile with valleys cut into them, on a frame of at most kReliefSide a side.
HeightField carved(const Making& making, const ScalarField& coordinate, const BuildParams& params,
                   double valley_spacing, const RunContext& run) {
  HeightField height(coordinate.frame());
  massif_rows(making, coordinate, params.massif, valley_spacing, height, run.part(0.0, 0.2));
  if (params.relief <= 0) return height;
  const HeightField before = height;
  ScalarField strength(coordinate.frame());
  const auto land_scale = static_cast<float>(1.0 / std::max(20.0, 0.06 * making.peak));
  parallel_rows(run, height.width(), height.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      gully_strength_row(coordinate.row(y).data(), height.row(y).data(), land_scale, strength.row(y).data(),
                         height.width());
  });
  geom::Gullies gullies;
  gullies.wavelength_m = valley_spacing;
  gullies.octaves = 8;
  gullies.strength = kCarving * params.relief * std::min(1.0, 0.6 * making.radius / valley_spacing);
  geom::add_gullies(height, making.seed.derive("island.gullies"), gullies, strength, run.part(0.2, 0.95));
  parallel_rows(run.part(0.95, 1.0), height.width(), height.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) bound_by_height(before.row(y).data(), height.row(y).data(), height.width());
  });
  return height;
}

/// What carving changes, on a coarse frame: for frames so large that detail below it comes from noise alone.
HeightField carving_change(const Making& making, const GridFrame& frame, const BuildParams& params,
                           double valley_spacing, const RunContext& run) {
  ScalarField coordinate(frame);
  coordinate_rows(making, frame, coordinate, run.part(0.0, 0.1));
  HeightField change = carved(making, coordinate, params, valley_spacing, run.part(0.1, 1.0));
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> plain(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      making.profile.evaluate(coordinate.row(y), plain);
      for (size_t x = 0; x < plain.size(); ++x) change.row(y)[x] -= plain[x];
    }
  });
  return change;
}

/// What interpolation of the change does beside the coast does not move it.
SEAMOUNT_VECTORISED void add_change(const float* __restrict change, int count, float* __restrict height) {
  for (int i = 0; i < count; ++i) {
    const float plain = height[i];
    const float bound = 0.2F * plain;
    const float z = plain + change[i];
    const float sunk = z > bound ? z : bound;
    const float raised = z < bound ? z : bound;
    height[i] = plain > 0.0F ? sunk : raised;
  }
}

/// The plain profile plus that change.
void profile_with_change(const Making& making, const HeightField& change, Island& island, const RunContext& run) {
  const GridFrame& frame = island.terrain.frame();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    geom::RowUpsampler rows(change);
    std::vector<float> added(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      making.profile.evaluate(island.coordinate.row(y), island.terrain.row(y));
      rows.read(frame.x(0), frame.cell_m, frame.y(y), added);
      add_change(added.data(), frame.width, island.terrain.row(y).data());
    }
  });
}

geom::CurveKind kind_of(Interpolation interpolation) {
  return interpolation == Interpolation::linear ? geom::CurveKind::linear : geom::CurveKind::monotone_cubic;
}

/// Fine noise, and labels.
void finish(const Making& making, Island& island, const RunContext& run) {
  const GridFrame& frame = island.terrain.frame();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> noise(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      const Part uneven = within(island.coordinate.row(y), 5.0F);
      if (uneven.count > 0) {
        geom::fbm_row(making.seed.derive("island.noise"), making.noise, frame.x(static_cast<double>(uneven.first)),
                      frame.cell_m, frame.y(y), {noise.data(), uneven.count});
        add_noise(noise.data(), &island.coordinate.row(y)[uneven.first], making.noise_m,
                  &island.terrain.row(y)[uneven.first], static_cast<int>(uneven.count));
      }
      label_row(island.coordinate.row(y).data(), reinterpret_cast<uint8_t*>(island.labels.row(y).data()), frame.width);
    }
  });
}

double highest_of(const Curve& curve) {
  double highest = 0.0;
  for (const Knot& knot : curve.knots) highest = std::max(highest, knot.y);
  return highest;
}

/// Those of the plan and the parameters; a profile without drawn summits says itself how high it rises.
std::vector<Peak> peaks_of(const Plan& plan, const BuildParams& params) {
  std::optional<double> highest = params.peak_m;
  if (!params.profile.knots.empty()) highest = std::max(1e-3, highest_of(params.profile));
  return choose_peaks(plan, params.summits, highest);
}

}  // namespace

Curve profile_curve(const Plan& plan, const BuildParams& params, double peak) {
  if (!params.profile.knots.empty()) {
    Curve curve = params.profile;
    const double highest = highest_of(curve);
    for (Knot& knot : curve.knots) knot.y *= knot.y > 0 && highest > 0 ? peak / highest : 1.0;
    return curve;
  }
  const double floor = params.floor_m.value_or(-std::clamp(0.16 * plan.widths.slope_m, 150.0, 2500.0));
  const double beach = std::min(5.0, 0.5 * peak);
  // Fractions of the summit's height and of the sea floor's depth: a worn shield with a moat, a reef flat and a steep
  // slope.
  Curve curve;
  for (const auto& [x, share] :
       {std::pair{0.0, 1.0}, {0.1, 0.93}, {0.22, 0.79}, {0.4, 0.58}, {0.6, 0.36}, {0.8, 0.165}, {0.93, 0.05}}) {
    curve.knots.push_back({x, beach + share * (peak - beach)});
  }
  curve.knots.push_back({1.0, beach});
  curve.knots.push_back({2.0, 0.0});
  curve.knots.push_back({2.3, std::max(-1.2, 0.1 * floor)});
  curve.knots.push_back({3.0, std::max(-3.0, 0.2 * floor)});
  curve.knots.push_back({3.8, std::max(-9.0, 0.25 * floor)});
  curve.knots.push_back({4.0, std::max(-22.0, 0.35 * floor)});
  for (const auto& [x, share] : {std::pair{4.12, 0.16}, {4.35, 0.5}, {4.65, 0.85}, {5.0, 1.0}}) {
    curve.knots.push_back({x, std::min(curve.knots.back().y - 0.01, share * floor)});
  }
  return curve;
}

namespace {

/// The profile's part over the land as shares of its height, made to descend strictly, for summits of other heights.
geom::CurveFunction shape_of(const geom::CurveFunction& profile) {
  constexpr int kSamples = 256;
  constexpr double kTilt = 0.02;
  std::vector<double> share(kSamples + 1);
  double above = 0.0;
  for (int i = kSamples; i >= 0; --i) {
    const double x = static_cast<double>(i) / kSamples;
    above = std::max(above, profile(x) - profile(1.0));
    share[static_cast<size_t>(i)] = above;
  }
  Curve curve;
  for (int i = 0; i <= kSamples; ++i) {
    const double x = static_cast<double>(i) / kSamples;
    curve.knots.push_back({x, above > 0 ? share[static_cast<size_t>(i)] / above : 0.0});
  }
  const bool strict = std::adjacent_find(curve.knots.begin(), curve.knots.end(),
                                         [](const Knot& a, const Knot& b) { return b.y >= a.y; }) == curve.knots.end();
  if (!strict) {
    for (Knot& knot : curve.knots) knot.y = (1.0 - kTilt) * knot.y + kTilt * (1.0 - knot.x);
  }
  return geom::CurveFunction(curve, geom::CurveKind::linear);
}

}  // namespace

Island build(const Plan& drawn, const BuildParams& params, const GridFrame& frame, Seed seed, const RunContext& run) {
  check_params(params);
  check_fits(drawn, frame, "coast");
  const Plan plan = params.summits.empty() ? drawn : as_areas(drawn);
  std::vector<Peak> peaks = peaks_of(plan, params);
  if (plan.polar.empty()) add_side_peaks(params.massif, seed, peaks);
  const double peak = peaks.empty() ? 0.0 : peaks.front().height_m;
  const double radius = plan.lobes.empty() ? std::sqrt(plan.land_m2 / std::numbers::pi) : plan.lobes.front().radius_m;
  const double detail = params.detail.coast_m.value_or(plan.detail_m);
  const geom::CurveFunction profile(profile_curve(plan, params, peak), kind_of(params.interpolation), "profile");
  const Making making{
      RegionCoordinate(
          plan, frame, params.detail.smoothing, run.part(0.0, 0.2),
          {peaks, shape_of(profile), std::max(0.0, profile(1.0)), params.detail.width_variation, params.massif, seed}),
      geom::CurveTable(profile, 0.0, kOutlineCount, 8192),
      {.wavelength_m = std::max(1e-3, 7.0 * detail), .octaves = 8, .gain = 0.52, .cell_m = frame.cell_m},
      detail,
      detail > 0 && plan.polar.empty() ? coast_room(plan, frame, run) : ScalarField(),
      {.wavelength_m = params.detail.noise_wavelength_m, .octaves = 8, .gain = 0.5, .cell_m = frame.cell_m},
      static_cast<float>(params.detail.noise_m),
      radius,
      peak,
      seed};
  const double spacing = params.detail.valley_spacing_m.value_or(0.3 * radius);
  if (peak > radius && plan.land_m2 > 0)
    run.say("the summit is " + format_number(std::round(peak)) + " m high on land about " +
            format_number(std::round(2 * radius)) + " m across, steeper than 45 degrees (peak_m states its height)");
  const double coarse_cell = std::max(frame.width_m(), frame.height_m()) / kReliefSide;
  const bool large = coarse_cell > frame.cell_m;
  HeightField change;  // made before the island itself is allocated: it needs much scratch
  if (large)
    change = carving_change(making, geom::coarser_frame(frame, coarse_cell), params, spacing, run.part(0.2, 0.5));
  Island island{HeightField(large ? frame : GridFrame{}), LabelMap(frame), ScalarField(frame)};
  coordinate_rows(making, frame, island.coordinate, run.part(0.5, 0.6));
  if (large) {
    profile_with_change(making, change, island, run.part(0.6, 0.9));
  } else {
    island.terrain = carved(making, island.coordinate, params, spacing, run.part(0.6, 0.9));
  }
  const Grid<uint8_t> basins = craters(peaks, profile, frame);
  if (plan.land_m2 > 0) {
    const int side = std::min(kValleySide, std::max(frame.width, frame.height) / 3 + 1);
    geom::raise_pits(island.terrain, 0.0F, kValleySlope, side, basins, run);
  }
  finish(making, island, run.part(0.9, 1.0));
  if (plan.land_m2 > 0) {
    set_peak_heights(island.terrain, peaks, run);
    geom::breach_pits(island.terrain, 0.0F, basins, run);
  }
  return island;
}

}  // namespace seamount::island

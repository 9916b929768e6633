#include "seamount/ops/island/build.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/gullies.h"
#include "seamount/ops/island/coordinate.h"

namespace seamount::island {
namespace {

constexpr int kReliefSide = 4096;

/// Everything that a row of the island is made from.
struct Making {
  RegionCoordinate coordinate;
  geom::CurveTable profile;
  geom::Fbm coast_detail;
  double coast_detail_m;
  geom::Fbm noise;
  float noise_m;
  Seed seed;
};

/// Noise fades out where the height is 0, so the coast stays where it is, and towards the sea floor, which is flat.
SEAMOUNT_VECTORISED void add_noise(const float* __restrict noise, const float* __restrict coordinate, float noise_m,
                                   float* __restrict height, int count) {
  for (int i = 0; i < count; ++i) {
    const float z = height[i];
    const float share = (z < 0 ? -z : z) * (1.0F / 12.0F);
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

/// How deep gullies may cut: fully on land above the beach, half on the slopes of the deep, not in lagoon and reef.
SEAMOUNT_VECTORISED void gully_strength_row(const float* coordinate, const float* height, float land_scale,
                                            float* strength, int count) {
  for (int i = 0; i < count; ++i) {
    const float x = coordinate[i];
    const float on_land = height[i] > 0.0F ? height[i] * land_scale : 0.0F;
    const float under_water = x > 4.0F ? 0.45F * (x - 4.0F) * 2.5F : 0.0F;
    const float s = x < 2.0F ? on_land : (under_water < 0.45F ? under_water : 0.45F);
    strength[i] = s < 1.0F ? s : 1.0F;
  }
}

void coordinate_rows(const Making& making, const GridFrame& frame, ScalarField& out, const RunContext& run) {
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> shift(static_cast<size_t>(frame.width), 0.0F);
    for (int y = begin; y < end; ++y) {
      if (making.coast_detail_m > 0) {
        std::fill(shift.begin(), shift.end(), 0.0F);
        geom::fbm_add_row(making.seed.derive("island.coast_detail"), making.coast_detail, frame.x(0), frame.cell_m,
                          frame.y(y), shift, static_cast<float>(making.coast_detail_m));
      }
      making.coordinate.row(frame.x(0), frame.cell_m, frame.y(y), shift, out.row(y));
    }
  });
}

/// Land rises and falls by broad noise, in proportion to its height: 0 at the coast.
SEAMOUNT_VECTORISED void add_massif(const float* __restrict noise, float amount, float* __restrict height, int count) {
  for (int i = 0; i < count; ++i) {
    const float factor = 1.0F + amount * noise[i];
    height[i] = height[i] > 0.0F ? height[i] * (factor > 0.25F ? factor : 0.25F) : height[i];
  }
}

/// Valleys end at the sea: land keeps a share of the profile's height.
SEAMOUNT_VECTORISED void keep_above(const float* __restrict profile, float* __restrict height, int count) {
  for (int i = 0; i < count; ++i) {
    const float least = 0.2F * profile[i];
    height[i] = profile[i] > 0.0F && height[i] < least ? least : height[i];
  }
}

/// Heights of the profile with valleys cut into them, on a frame of at most kReliefSide a side.
HeightField carved(const Making& making, const ScalarField& coordinate, const BuildParams& params,
                   double valley_spacing, double peak, Seed seed, const RunContext& run) {
  HeightField height(coordinate.frame());
  ScalarField strength(coordinate.frame());
  const auto land_scale = static_cast<float>(1.0 / std::max(30.0, 0.12 * peak));
  const geom::Fbm massif{.wavelength_m = 3.2 * valley_spacing, .octaves = 4, .gain = 0.5, .cell_m = height.cell_m()};
  parallel_rows(run.part(0.0, 0.2), height.width(), height.height(), [&](int begin, int end) {
    std::vector<float> noise(static_cast<size_t>(height.width()), 0.0F);
    for (int y = begin; y < end; ++y) {
      making.profile.evaluate(coordinate.row(y), height.row(y));
      if (params.massif > 0) {
        geom::fbm_row(seed.derive("island.massif"), massif, height.frame().x(0), height.cell_m(), height.frame().y(y),
                      noise);
        add_massif(noise.data(), static_cast<float>(params.massif), height.row(y).data(), height.width());
      }
      gully_strength_row(coordinate.row(y).data(), height.row(y).data(), land_scale, strength.row(y).data(),
                         height.width());
    }
  });
  if (params.relief > 0) {
    geom::Gullies gullies;
    gullies.wavelength_m = valley_spacing;
    gullies.octaves = 8;
    gullies.strength = params.relief;
    geom::add_gullies(height, seed.derive("island.gullies"), gullies, strength, run.part(0.2, 0.95));
    parallel_rows(run.part(0.95, 1.0), height.width(), height.height(), [&](int begin, int end) {
      std::vector<float> profile(static_cast<size_t>(height.width()));
      for (int y = begin; y < end; ++y) {
        making.profile.evaluate(coordinate.row(y), profile);
        keep_above(profile.data(), height.row(y).data(), height.width());
      }
    });
  }
  return height;
}

/// What carving changes, on a coarse frame: for frames so large that detail below it comes from noise alone.
HeightField carving_change(const Making& making, const GridFrame& frame, const BuildParams& params,
                           double valley_spacing, double peak, Seed seed, const RunContext& run) {
  ScalarField coordinate(frame);
  coordinate_rows(making, frame, coordinate, run.part(0.0, 0.1));
  HeightField change = carved(making, coordinate, params, valley_spacing, peak, seed, run.part(0.1, 1.0));
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> plain(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      making.profile.evaluate(coordinate.row(y), plain);
      for (size_t x = 0; x < plain.size(); ++x) change.row(y)[x] -= plain[x];
    }
  });
  return change;
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
      for (size_t x = 0; x < added.size(); ++x) island.terrain.row(y)[x] += added[x];
    }
  });
}

geom::CurveKind kind_of(Interpolation interpolation) {
  return interpolation == Interpolation::linear ? geom::CurveKind::linear : geom::CurveKind::monotone_cubic;
}

}  // namespace

Curve profile_curve(const Plan& plan, const BuildParams& params) {
  if (!params.profile.knots.empty()) return params.profile;
  const double land = std::sqrt(plan.land_m2);
  const double peak = params.peak_m.value_or(std::min(4200.0, 110.0 * std::pow(land / 1000.0, 0.78)));
  const double floor = params.floor_m.value_or(-std::clamp(0.16 * plan.widths.slope_m, 150.0, 2500.0));
  const double beach = std::min(5.0, 0.5 * peak);
  // Fractions of the summit's height and of the sea floor's depth: a worn shield with a moat, a reef flat and a steep
  // slope.
  Curve curve;
  for (const auto& [x, share] :
       {std::pair{0.0, 1.0}, {0.1, 0.93}, {0.22, 0.76}, {0.4, 0.5}, {0.6, 0.27}, {0.8, 0.1}, {0.93, 0.028}}) {
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

Island build(const Plan& plan, const BuildParams& params, const GridFrame& frame, Seed seed, const RunContext& run) {
  check_params(params);
  check_fits(plan, frame, "coast");
  const Curve curve = profile_curve(plan, params);
  const double radius = std::sqrt(plan.land_m2 / std::numbers::pi);
  const double detail = params.detail.coast_m.value_or(0.35 * plan.edge_m);
  const Making making{
      RegionCoordinate(plan, frame, params.detail.smoothing, run.part(0.0, 0.2)),
      geom::CurveTable(geom::CurveFunction(curve, kind_of(params.interpolation), "profile"), 0.0, kOutlineCount, 8192),
      {.wavelength_m = std::max(1e-3, 7.0 * detail), .octaves = 8, .gain = 0.52, .cell_m = frame.cell_m},
      detail,
      {.wavelength_m = params.detail.noise_wavelength_m, .octaves = 8, .gain = 0.5, .cell_m = frame.cell_m},
      static_cast<float>(params.detail.noise_m),
      seed};
  const double spacing = params.detail.valley_spacing_m.value_or(0.3 * radius);
  const double peak = std::max_element(curve.knots.begin(), curve.knots.end(), [](const Knot& a, const Knot& b) {
                        return a.y < b.y;
                      })->y;
  if (peak > radius && plan.land_m2 > 0)
    run.say("the summit is " + format_number(std::round(peak)) + " m high on land about " +
            format_number(std::round(2 * radius)) + " m across, steeper than 45 degrees (peak_m states its height)");
  const double coarse_cell = std::max(frame.width_m(), frame.height_m()) / kReliefSide;
  const bool large = coarse_cell > frame.cell_m;
  HeightField change;  // made before the island itself is allocated: it needs much scratch
  if (large) {
    change = carving_change(making, geom::coarser_frame(frame, coarse_cell), params, spacing, peak, seed,
                            run.part(0.2, 0.5));
  }
  Island island{HeightField(large ? frame : GridFrame{}), LabelMap(frame), ScalarField(frame)};
  coordinate_rows(making, frame, island.coordinate, run.part(0.5, 0.6));
  if (large) {
    profile_with_change(making, change, island, run.part(0.6, 0.9));
  } else {
    island.terrain = carved(making, island.coordinate, params, spacing, peak, seed, run.part(0.6, 0.9));
  }
  parallel_rows(run.part(0.9, 1.0), frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> noise(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      geom::fbm_row(seed.derive("island.noise"), making.noise, frame.x(0), frame.cell_m, frame.y(y), noise);
      add_noise(noise.data(), island.coordinate.row(y).data(), making.noise_m, island.terrain.row(y).data(),
                frame.width);
      label_row(island.coordinate.row(y).data(), reinterpret_cast<uint8_t*>(island.labels.row(y).data()), frame.width);
    }
  });
  return island;
}

}  // namespace seamount::island

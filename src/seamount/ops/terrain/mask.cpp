#include "seamount/ops/terrain/mask.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/joined_lines.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/same_size.h"

namespace seamount::terrain {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// A soft range in float: rise = (x - low) / falloff + 1, fall = (high - x) / falloff + 1. Without a falloff a step, by
/// a falloff so small that no two heights lie within it.
struct Pass {
  float low, high, scale;
};

Pass make_pass(std::optional<double> low, std::optional<double> high, double falloff) {
  return {static_cast<float>(low.value_or(-kNoEnd)), static_cast<float>(high.value_or(kNoEnd)),
          falloff > 0.0 ? static_cast<float>(1.0 / falloff) : 1e30F};
}

SEAMOUNT_INLINE float pass_value(float x, Pass p) {
  const float below = x < p.low ? (p.low - x) * p.scale : 0.0F;
  const float above = x > p.high ? (x - p.high) * p.scale : 0.0F;
  return 1.0F - geom::smoothstep(below > above ? below : above);
}

SEAMOUNT_VECTORISED void pass_row(const Pass p, bool invert, int count, float* __restrict x) {
  const float from = invert ? 1.0F : 0.0F, times = invert ? -1.0F : 1.0F;
  for (int i = 0; i < count; ++i) x[i] = from + times * pass_value(x[i], p);
}

/// Bearings of the fall to how far they lie from a direction, in [0, 180].
SEAMOUNT_VECTORISED void turn_row(float direction, int count, float* __restrict aspect) {
  for (int i = 0; i < count; ++i) {
    const float d = aspect[i] > direction ? aspect[i] - direction : direction - aspect[i];
    aspect[i] = d > 180.0F ? 360.0F - d : d;
  }
}

SEAMOUNT_VECTORISED void combine_row(Combine how, int count, const float* __restrict weights, float* __restrict mask) {
  if (how == Combine::product) {
    for (int i = 0; i < count; ++i) mask[i] *= weights[i];
  } else if (how == Combine::min) {
    for (int i = 0; i < count; ++i) mask[i] = mask[i] < weights[i] ? mask[i] : weights[i];
  } else {
    for (int i = 0; i < count; ++i) mask[i] = mask[i] > weights[i] ? mask[i] : weights[i];
  }
}

template <class Body>
void each_row(const ScalarField& field, const RunContext& run, Body&& body) {
  parallel_rows(run, field.width(), field.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) body(y);
  });
}

/// Distance from the border of the cells that `inside` picks, negative within them; +-infinity without a border.
template <class Inside>
ScalarField signed_cell_distance(const GridFrame& frame, Inside&& inside, const RunContext& run) {
  Grid<uint8_t> within(frame), beyond(frame);
  for (size_t i = 0; i < within.size(); ++i) {
    within.cells()[i] = inside(i) ? 1 : 0;
    beyond.cells()[i] = inside(i) ? 0 : 1;
  }
  ScalarField distance = geom::distance_to(within, run);
  const ScalarField depth = geom::distance_to(beyond, run);
  const auto half = static_cast<float>(0.5 * frame.cell_m);
  for (size_t i = 0; i < distance.size(); ++i) {
    float& d = distance.cells()[i];
    d = within.cells()[i] != 0 ? half - depth.cells()[i] : d - half;
  }
  return distance;
}

/// 0 where nothing is known of a field.
void select_nothing_unknown(const ScalarField& field, ScalarField& weights) {
  for (size_t i = 0; i < field.size(); ++i)
    if (std::isnan(field.cells()[i])) weights.cells()[i] = 0.0F;
}

void say_if_nothing(const Mask& mask, const RunContext& run) {
  const auto cells = mask.cells();
  if (std::all_of(cells.begin(), cells.end(), [](float w) { return w == 0.0F; })) run.say("nothing is selected");
}

/// From shares to what unselected and selected ground gets, both exactly.
void give_values(const MaskParams& params, Mask& mask) {
  if (params.low == 0.0 && params.high == 1.0) return;
  for (float& w : mask.cells()) w = static_cast<float>((1.0 - w) * params.low + w * params.high);
}

/// Weights of one criterion after another.
class Judge {
 public:
  Judge(const MaskInputs& in, Seed seed, const RunContext& run) : in_(in), seed_(seed), run_(run) {}

  /// Weights of criterion `index`.
  ScalarField weights(const Criterion& criterion, size_t index) {
    place_ = "criteria[" + std::to_string(index) + "]";
    index_ = index;
    return std::visit([&](const auto& by) { return judge(by); }, criterion);
  }

 private:
  [[noreturn]] void fail(const std::string& member, const std::string& problem) const {
    throw InvalidArgument(place_ + (member.empty() ? "" : "." + member), problem);
  }

  /// Lets the range through, in place.
  ScalarField pass(ScalarField measured, std::optional<double> low, std::optional<double> high, double falloff,
                   bool invert) const {
    if (low && high && *low > *high) fail("low", format_number(*low) + " is above high = " + format_number(*high));
    const Pass p = make_pass(low, high, falloff);
    each_row(measured, run_, [&](int y) { pass_row(p, invert, measured.width(), measured.row(y).data()); });
    return measured;
  }

  ScalarField judge(const ByHeight& by) const {
    return pass(in_.terrain, by.low_m, by.high_m, by.falloff_m, by.invert);
  }

  ScalarField judge(const ByDepth& by) const {
    const ByValue height = over_the_sea(by);
    return pass(geom::fill_hollows(in_.terrain, 0.0F, kDryGround_m, run_), height.low, height.high, height.falloff,
                height.invert);
  }

  ScalarField judge(const BySlope& by) const {
    return pass(geom::slope_deg(geom::at_scale(in_.terrain, by.scale_m, run_), run_), by.low_deg, by.high_deg,
                by.falloff_deg, by.invert);
  }

  ScalarField judge(const ByAspect& by) const {
    const HeightField smooth = geom::at_scale(in_.terrain, by.scale_m, run_);
    ScalarField away = geom::aspect_deg(smooth, run_);
    const auto direction = static_cast<float>(by.direction_deg - 360.0 * std::floor(by.direction_deg / 360.0));
    each_row(away, run_, [&](int y) { turn_row(direction, away.width(), away.row(y).data()); });
    ScalarField facing = pass(std::move(away), std::nullopt, 0.5 * by.spread_deg, by.falloff_deg, false);
    const ScalarField steep = pass(geom::slope_deg(smooth, run_), by.level_deg, std::nullopt, by.level_deg, false);
    each_row(facing, run_,
             [&](int y) { combine_row(Combine::product, facing.width(), steep.row(y).data(), facing.row(y).data()); });
    return by.invert ? pass(std::move(facing), 1.0, std::nullopt, 1.0, true) : facing;
  }

  ScalarField judge(const ByCurvature& by) const {
    constexpr std::array<geom::Curvature, 3> kKinds = {geom::Curvature::profile, geom::Curvature::plan,
                                                       geom::Curvature::mean};
    const auto per_m = [](std::optional<double> c) { return c ? std::optional(1e-3 * *c) : std::nullopt; };
    ScalarField bend =
        geom::curvature(geom::at_scale(in_.terrain, by.scale_m, run_), kKinds[static_cast<size_t>(by.bend)], run_);
    return pass(std::move(bend), per_m(by.low_per_km), per_m(by.high_per_km), 1e-3 * by.falloff_per_km, by.invert);
  }

  ScalarField judge(const ByRegion& by) const {
    if (in_.labels == nullptr) fail("", "selects by region, but the input 'labels' is open: connect a label map");
    const LabelMap& labels = *in_.labels;
    return pass(signed_cell_distance(
                    in_.terrain.frame(), [&](size_t i) { return labels.cells()[i] == by.region; }, run_),
                by.low_m, by.high_m, by.falloff_m, by.invert);
  }

  ScalarField judge(const ByArea& by) const {
    std::vector<Polygon> polygons = by.polygons;
    if (polygons.empty()) {
      if (in_.drawing == nullptr) fail("", "selects areas, but has no polygons and the input 'drawing' is open");
      for (const NamedArea& area : in_.drawing->areas) {
        if (by.feature.empty() || area.name == by.feature)
          polygons.insert(polygons.end(), area.parts.begin(), area.parts.end());
      }
      if (polygons.empty() && in_.drawing->areas.empty() && by.feature.empty())
        for (const NamedArea& area : geom::areas_from_lines(in_.drawing->lines).areas)
          polygons.insert(polygons.end(), area.parts.begin(), area.parts.end());
      if (polygons.empty())
        fail("feature", "the drawing has no area" + (by.feature.empty() ? "" : " '" + by.feature + "'"));
    }
    return pass(geom::signed_distance(polygons, in_.terrain.frame(), run_), by.low_m, by.high_m, by.falloff_m,
                by.invert);
  }

  ScalarField judge(const ByLine& by) const {
    std::vector<Polyline> lines;
    if (by.points.size() > 1) lines.push_back(by.points);
    if (by.points.size() == 1) fail("points", "a line needs two points");
    if (lines.empty()) {
      if (in_.drawing == nullptr) fail("", "selects by a line, but has no points and the input 'drawing' is open");
      for (const ValuedLine& line : in_.drawing->lines) {
        lines.push_back(line.points);
        if (line.closed && !line.points.empty()) lines.back().push_back(line.points.front());
      }
      if (lines.empty()) fail("points", "the drawing has no lines");
    }
    return pass(geom::distance_to_lines(lines, in_.terrain.frame(), run_), by.low_m, by.high_m, by.falloff_m,
                by.invert);
  }

  ScalarField judge(const ByNoise& by) const {
    const GridFrame& frame = in_.terrain.frame();
    if (by.coverage <= 0.0 || by.coverage >= 1.0)
      return ScalarField(frame, (by.coverage >= 1.0) != by.invert ? 1.0F : 0.0F);
    // Noise is about normal with a deviation of 0.35; the border of coverage runs where the weight is one half.
    const double threshold = 0.35 / 1.702 * std::log((1.0 - by.coverage) / by.coverage);
    const double falloff = 0.9 * by.softness;
    const geom::Fbm shape{
        .wavelength_m = by.wavelength_m, .octaves = by.octaves, .gain = by.gain, .cell_m = frame.cell_m};
    return pass(geom::fbm_grid(frame, seed_.derive("terrain.mask", index_), shape, run_), threshold + 0.5 * falloff,
                std::nullopt, falloff, by.invert);
  }

  ScalarField judge(const ByValue& by) const {
    if (in_.values == nullptr) fail("", "selects by value, but the input 'values' is open: connect a field");
    ScalarField weights = pass(*in_.values, by.low, by.high, by.falloff, by.invert);
    select_nothing_unknown(*in_.values, weights);
    return weights;
  }

  const MaskInputs& in_;
  Seed seed_;
  const RunContext& run_;
  std::string place_;
  size_t index_ = 0;
};

void check_inputs(const MaskInputs& in) {
  const GridFrame& frame = in.terrain.frame();
  if (in.terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  if (in.labels != nullptr) check_same_size("labels", in.labels->frame(), frame);
  if (in.values != nullptr) check_same_size("values", in.values->frame(), frame);
  if (in.mask != nullptr) check_same_size("mask", in.mask->frame(), frame);
}

}  // namespace

ByValue over_the_sea(const ByDepth& by) {
  const auto negative = [](std::optional<double> depth) { return depth ? std::optional(-*depth) : std::nullopt; };
  return {negative(by.high_m), negative(by.low_m), by.falloff_m, by.invert};
}

double soft_range(double x, std::optional<double> low, std::optional<double> high, double falloff) {
  const double outside = std::max({low ? *low - x : 0.0, high ? x - *high : 0.0, 0.0});
  if (outside == 0.0) return 1.0;
  return falloff > 0.0 ? 1.0 - geom::smoothstep(outside / falloff) : 0.0;
}

namespace {

Mask mask_known(const MaskInputs& in, const MaskParams& params, Seed seed, const RunContext& run) {
  const GridFrame& frame = in.terrain.frame();
  const bool first_decides = params.combine == Combine::max && (in.mask != nullptr || !params.criteria.empty());
  Mask out(frame, first_decides ? 0.0F : 1.0F);
  const auto add = [&](const ScalarField& weights, const RunContext& part) {
    each_row(out, part,
             [&](int y) { combine_row(params.combine, frame.width, weights.row(y).data(), out.row(y).data()); });
  };
  const double steps = static_cast<double>(params.criteria.size()) + 1.0;
  if (in.mask != nullptr) {
    Mask clamped = *in.mask;
    each_row(clamped, run.part(0.0, 0.5 / steps), [&](int y) {
      for (float& w : clamped.row(y)) w = w > 0.0F ? std::min(w, 1.0F) : 0.0F;  // what is not a number is nothing
    });
    add(clamped, run.part(0.5 / steps, 1.0 / steps));
  }
  for (size_t i = 0; i < params.criteria.size(); ++i) {
    const double from = (static_cast<double>(i) + 1.0) / steps;
    const RunContext part = run.part(from, from + 1.0 / steps);
    Judge judge(in, seed, part);
    add(judge.weights(params.criteria[i], i), {run.threads, {}, run.cancelled});
  }
  if (params.invert) {
    each_row(out, {run.threads, {}, run.cancelled}, [&](int y) {
      for (float& w : out.row(y)) w = 1.0F - w;
    });
  }
  return out;
}

}  // namespace

namespace {

Reach reach_of(const ByDepth&, double) {
  return Reach::everything("the criterion depth looks for the sea everywhere; height with high_m 0 does not");
}
Reach reach_of(const BySlope& by, double cell_m) {
  return Reach::neighbourhood(geom::scale_reach(by.scale_m, cell_m) + 1);
}
Reach reach_of(const ByAspect& by, double cell_m) {
  return Reach::neighbourhood(geom::scale_reach(by.scale_m, cell_m) + 1);
}
Reach reach_of(const ByCurvature& by, double cell_m) {
  return Reach::neighbourhood(geom::scale_reach(by.scale_m, cell_m) + 1);
}
/// Beyond its limits and the falloff a region's distance no longer counts.
Reach reach_of(const ByRegion& by, double cell_m) {
  constexpr double kMost = 1 << 24;
  const double limit_m = std::max(std::abs(by.low_m.value_or(0.0)), std::abs(by.high_m.value_or(0.0))) + by.falloff_m;
  return Reach::neighbourhood(static_cast<int>(std::min(std::ceil(limit_m / cell_m), kMost)) + 2);
}
template <class By>
Reach reach_of(const By&, double) {
  return Reach::place();
}

/// Does a criterion look at the ground beside a cell? Then unknown ground there must be filled.
bool looks_beside(const Criterion& criterion) {
  return std::holds_alternative<ByDepth>(criterion) || std::holds_alternative<BySlope>(criterion) ||
         std::holds_alternative<ByAspect>(criterion) || std::holds_alternative<ByCurvature>(criterion);
}
bool looks_beside(const MaskParams& params) {
  return std::any_of(params.criteria.begin(), params.criteria.end(),
                     [](const Criterion& criterion) { return looks_beside(criterion); });
}

}  // namespace

Reach mask_reach(const MaskParams& params, double cell_m) {
  Reach reach = Reach::place();
  for (const Criterion& criterion : params.criteria)
    reach = reach.with(std::visit([&](const auto& by) { return reach_of(by, cell_m); }, criterion));
  reach.known = looks_beside(params);
  return reach;
}

Mask mask(const MaskInputs& in, const MaskParams& params, Seed seed, const RunContext& run) {
  check_params(params);
  check_inputs(in);
  run.check_cancelled();
  const bool holes = geom::count_voids(in.terrain, run) > 0;
  Mask out;
  if (holes && looks_beside(params)) {
    HeightField filled = in.terrain;  // slopes at the rim of a hole need something beyond it
    geom::fill_voids(filled, run.part(0.0, 0.2));
    out = mask_known({filled, in.labels, in.drawing, in.values, in.mask}, params, seed, run.part(0.2, 1.0));
  } else {
    out = mask_known(in, params, seed, run);
  }
  if (holes) select_nothing_unknown(in.terrain, out);
  say_if_nothing(out, run);
  give_values(params, out);
  return out;
}

}  // namespace seamount::terrain

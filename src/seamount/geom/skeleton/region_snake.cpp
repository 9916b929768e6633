// See region_snake.h.
#include "seamount/geom/skeleton/region_snake.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/skeleton/region_line.h"
#include "seamount/geom/skeleton/tangles.h"

namespace seamount::geom {
namespace {

constexpr int64_t kRegionsPerBlock = 1;
constexpr int kGrowingSteps = 8;
constexpr int kStages = 60;
constexpr double kGrowth = 1.25;
/// Steps after which vertices are looked over.
constexpr int kStepsBetween = 25;
/// A raster first reaches this many radii, and is widened by this share of its outline's extent.
/// An outline this much longer than its target is across is taken up more coarsely.
constexpr double kMostTargets = 100.0;
constexpr double kMostVertices = 2048.0;
constexpr double kMostAcross = 512.0;
constexpr double kMostSamples = 4e6;
constexpr double kReach = 1.5;
constexpr double kWidening = 0.3;

void check(const RegionOptions& options) {
  const auto hold = [](bool holds, const char* name, const char* rule) {
    if (!holds) throw InvalidArgument(name, rule);
  };
  const auto from_0 = [&](double value, const char* name) {
    hold(value >= 0.0 && std::isfinite(value), name, "must be a number from 0 on");
  };
  from_0(options.internal, "internal");
  from_0(options.shape, "shape");
  from_0(options.bend_m, "bend_m");
  from_0(options.spacing_m, "spacing_m");
  from_0(options.raster_m, "raster_m");
  from_0(options.field_unit, "field_unit");
  from_0(options.least_gain, "least_gain");
  hold(std::isfinite(options.inside), "inside", "must be a number");
  hold(std::isfinite(options.border), "border", "must be a number");
  hold(options.steps >= 0, "steps", "must not be negative");
}

class Regions {
 public:
  Regions(const FieldAtPlaces& field, const RegionOptions& options, const RunContext& run)
      : options_(options), field_(field), run_(run) {}

  std::vector<RegionLine> lines;

  /// Makes the rasters of those cover a box each; one call of the field.
  template <class Wanted>
  void cover(const std::vector<size_t>& those, Wanted&& box_of) {
    places_.clear();
    std::vector<size_t> wider;
    for (const size_t i : those) {
      const Box box = box_of(lines[i]);
      if (lines[i].raster.covers(box)) continue;
      const Vec2 more = kWidening * (box.high - box.low);
      if (lines[i].raster.size_with({box.low - more, box.high + more}) > kMostSamples) continue;
      lines[i].raster.add_missing({box.low - more, box.high + more}, places_);
      wider.push_back(i);
    }
    values_.resize(places_.size());
    if (!places_.empty()) field_(places_, values_);
    size_t next = 0;
    for (const size_t i : wider) {
      const size_t count = lines[i].raster.missing();
      lines[i].raster.fill(std::span<const double>(values_).subspan(next, count));
      next += count;
    }
  }

  /// After the first cover().
  void check_covered() const {
    for (size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].raster.covers(lines[i].reach_of(lines[i].points))) continue;
      throw InvalidArgument("raster_m", "is too fine for region " + std::to_string(i + 1) +
                                            ": a raster may have at most 4 million samples");
    }
  }

  void descend(std::vector<size_t> those, int steps, double growth) {
    for_each(those, [&](size_t, RegionLine& line) { line.start(growth); });
    std::vector<const std::vector<Vec2>*> proposals(lines.size());
    for (int step = 0; step < steps && !those.empty(); ++step) {
      run_.check_cancelled();
      for_each(those, [&](size_t i, RegionLine& line) { proposals[i] = &line.propose(); });
      cover(those, [&](const RegionLine& line) {
        return line.reach_of(*proposals[static_cast<size_t>(&line - lines.data())]);
      });
      for_each(those, [&](size_t, RegionLine& line) { line.judge(options_.least_gain); });
      std::erase_if(those, [&](size_t i) { return lines[i].rests(); });
    }
  }

  /// To the target area by stages, then to rest.
  void fit(const std::vector<size_t>& those) {
    std::vector<size_t> changing = those;
    std::vector<int> idle(lines.size(), 0);
    for (int stage = 0; stage < kStages; ++stage) {
      std::erase_if(changing, [&](size_t i) {
        return !lines[i].has_target() || idle[i] > 2 || std::abs(lines[i].area() / lines[i].target() - 1.0) < 0.02;
      });
      if (changing.empty()) break;
      std::vector<double> before(lines.size());
      for (const size_t i : changing) before[i] = lines[i].area();
      descend(changing, kGrowingSteps, kGrowth);
      for (const size_t i : changing) idle[i] = std::abs(lines[i].area() / before[i] - 1.0) < 0.01 ? idle[i] + 1 : 0;
      spread_uneven(changing);
      run_.report(0.5 * (stage + 1.0) / kStages);
    }
    std::vector<size_t> active = those;
    for (int step = 0; step < options_.steps && !active.empty(); step += kStepsBetween) {
      spread_uneven(active);
      descend(active, std::min(kStepsBetween, options_.steps - step), 1e6);
      std::erase_if(active, [&](size_t i) { return lines[i].rests() && !lines[i].is_uneven(); });
    }
    run_.report(1.0);
  }

  template <class Body>
  void for_each(const std::vector<size_t>& those, Body&& body) {
    RunContext quiet = run_;
    quiet.progress = nullptr;
    parallel_blocks(quiet, static_cast<int64_t>(those.size()), kRegionsPerBlock, [&](int64_t begin, int64_t end) {
      for (int64_t k = begin; k < end; ++k) body(those[static_cast<size_t>(k)], lines[those[static_cast<size_t>(k)]]);
    });
  }

 private:
  void spread_uneven(const std::vector<size_t>& those) {
    for_each(those, [](size_t, RegionLine& line) {
      if (line.is_uneven()) line.spread();
    });
  }

  const RegionOptions& options_;
  const FieldAtPlaces& field_;
  const RunContext& run_;
  std::vector<Vec2> places_;
  std::vector<double> values_;
};

std::vector<RegionFit> results_of(std::vector<RegionLine>& lines) {
  std::vector<RegionFit> results(lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    RegionLine& line = lines[i];
    RegionFit& fit = results[i];
    fit.skeleton.kind = SkeletonKind::region;
    if (!line.points.empty()) {
      fit.area_m2 = line.area();
      fit.mean_field = line.mean_field();
    }
    fit.rests = line.rests();
    if (std::any_of(line.hold.begin(), line.hold.end(), [](float h) { return h != 0.0F; })) {
      fit.skeleton.hold = std::move(line.hold);
    }
    fit.skeleton.points = std::move(line.points);
    fit.steps = std::move(line.steps);
  }
  return results;
}

void check(const RegionOutlineToFit& outline, size_t number) {
  const auto refuse = [&](const std::string& problem) {
    throw InvalidArgument("region " + std::to_string(number + 1), problem);
  };
  const Polyline& points = outline.skeleton.points;
  if (points.size() < 3) refuse("has " + std::to_string(points.size()) + " points; it takes at least 3");
  for (const Vec2 p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) refuse("has a place that is not finite");
  }
  if (!outline.skeleton.hold.empty() && outline.skeleton.hold.size() != points.size()) {
    refuse("has " + std::to_string(outline.skeleton.hold.size()) + " holds for " + std::to_string(points.size()) +
           " points");
  }
  if (!(outline.area_m2 >= 0.0) || !std::isfinite(outline.area_m2)) refuse("has a target area below 0");
}

}  // namespace

std::vector<RegionFit> grow_regions(std::span<const RegionSeed> seeds, const RegionOptions& options,
                                    const FieldAtPlaces& field, const RunContext& run) {
  check(options);
  Regions regions(field, options, run);
  std::vector<size_t> all;
  for (size_t i = 0; i < seeds.size(); ++i) {
    if (!(seeds[i].area_m2 > 0.0) || !std::isfinite(seeds[i].area_m2)) {
      throw InvalidArgument("seed " + std::to_string(i + 1), "needs an area above 0");
    }
    regions.lines.emplace_back(options, seeds[i].area_m2, seeds[i].area_m2, seeds[i].at, 0.0, 0.0);
    regions.lines.back().points = {seeds[i].at};
    all.push_back(i);
  }
  regions.cover(all, [](const RegionLine& line) {
    const double reach = kReach * line.radius_m() / (1.0 + 2.0 * kWidening);
    return Box{line.points[0] - Vec2{reach, reach}, line.points[0] + Vec2{reach, reach}};
  });
  regions.check_covered();
  std::vector<char> alive(seeds.size());
  regions.for_each(all, [&](size_t i, RegionLine& line) {
    line.measure(options.field_unit);
    alive[i] = line.seed(seeds[i].at) ? 1 : 0;
  });
  std::erase_if(all, [&](size_t i) { return alive[i] == 0; });
  regions.fit(all);
  return results_of(regions.lines);
}

std::vector<RegionFit> fit_regions(std::span<const RegionOutlineToFit> outlines, const RegionOptions& options,
                                   const FieldAtPlaces& field, const RunContext& run) {
  check(options);
  Regions regions(field, options, run);
  std::vector<size_t> sound;
  for (size_t i = 0; i < outlines.size(); ++i) {
    check(outlines[i], i);
    Skeleton skeleton = outlines[i].skeleton;
    if (skeleton.hold.empty()) skeleton.hold.assign(skeleton.points.size(), 0.0F);
    if (signed_area(skeleton.points) < 0.0) {
      std::reverse(skeleton.points.begin(), skeleton.points.end());
      std::reverse(skeleton.hold.begin(), skeleton.hold.end());
    }
    const double area = signed_area(skeleton.points);
    const double unit = outlines[i].area_m2 > 0.0 ? outlines[i].area_m2 : area;
    const Box box = bounding_box(skeleton.points);
    const double length = ring_length(skeleton.points);
    const bool is_long = length * length > kMostTargets * kMostTargets * unit;
    regions.lines.emplace_back(options, outlines[i].area_m2, unit > 0.0 ? unit : 1.0, 0.5 * (box.low + box.high),
                               std::max(box.high.x - box.low.x, box.high.y - box.low.y) / kMostAcross,
                               is_long ? length / kMostVertices : 0.0);
    regions.lines.back().points = std::move(skeleton.points);
    regions.lines.back().hold = std::move(skeleton.hold);
    if (area > 0.0 && find_tangles(regions.lines.back().points, true).empty()) sound.push_back(i);
  }
  std::vector<size_t> all(outlines.size());
  std::iota(all.begin(), all.end(), size_t{0});
  regions.cover(all, [](const RegionLine& line) { return line.reach_of(line.points); });
  regions.check_covered();
  regions.for_each(all, [&](size_t, RegionLine& line) { line.measure(options.field_unit); });
  regions.for_each(sound, [&](size_t, RegionLine& line) { line.spread(); });
  regions.fit(sound);
  return results_of(regions.lines);
}

}  // namespace seamount::geom

#include "seamount/ops/ecosystem/fit.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/skeleton/hill_climb.h"
#include "seamount/geom/skeleton/region_snake.h"
#include "seamount/geom/skeleton/snake.h"

namespace seamount::ecosystem {
namespace {

constexpr int32_t kNobody = geom::NearestSkeleton::kNobody;

const ObjectClass& class_at(const Scene& scene, int of_class) {
  return scene.catalogue.classes[static_cast<size_t>(of_class)];
}

/// The fitting field of a class, as an object sees it.
class Fitting {
 public:
  Fitting(const Scene& scene, const Rules& rules, const Environment& environment, int of_class, const RunContext& run)
      : survey_(scene, environment, run), expression_(rules.classes[static_cast<size_t>(of_class)].fitting) {
    const std::string& name = class_at(scene, of_class).name;
    differs_ = std::any_of(expression_.terms().begin(), expression_.terms().end(),
                           [&](const geom::Term& term) { return term.of_class == name || term.word == "age"; });
  }

  /// Does the field speak of the class itself or of age, so that each object sees another one?
  bool differs() const { return differs_; }

  geom::FieldAtPlaces seen_by(int32_t self, double age) const {
    return [this, self, age](std::span<const Vec2> places, std::span<double> values) {
      const std::vector<double> ages(places.size(), age);
      survey_.ask(expression_, {places, {&self, 1}, ages}, values);
    };
  }

  geom::FieldForPoints seen_by(const std::vector<int32_t>& selves, const std::vector<double>& ages) const {
    return
        [this, &selves, &ages](std::span<const Vec2> places, std::span<const size_t> whose, std::span<double> values) {
          std::vector<int32_t> self(places.size());
          std::vector<double> age(places.size());
          for (size_t i = 0; i < places.size(); ++i) {
            self[i] = selves[whose[i]];
            age[i] = ages[whose[i]];
          }
          survey_.ask(expression_, {places, self, age}, values);
        };
  }

 private:
  Survey survey_;
  const geom::Expression& expression_;
  bool differs_;
};

geom::ClimbOptions climb_options(const ObjectClass& of, double cell_m) {
  geom::ClimbOptions options;
  options.cell_m = cell_m;
  options.steps = of.shape.steps;
  options.most_distance_m = of.placement.spacing_m > 0 ? 0.5 * of.placement.spacing_m : cell_m;
  options.first_step_m = std::min(cell_m, options.most_distance_m);
  options.least_step_cells = 0.05;
  return options;
}

geom::SnakeOptions snake_options(const ObjectClass& of) {
  geom::SnakeOptions options;
  options.internal = of.shape.internal;
  options.external = of.shape.external;
  options.shape = of.shape.target;
  options.gradient = of.shape.gradient;
  options.steps = of.shape.steps;
  return options;
}

geom::RegionOptions region_options(const ObjectClass& of, double cell_m) {
  geom::RegionOptions options;
  options.internal = of.shape.internal;
  options.inside = of.shape.inside;
  options.border = of.shape.border;
  options.shape = of.shape.target;
  options.steps = of.shape.steps;
  options.raster_m = std::max(0.0, std::min(cell_m, std::sqrt(of.shape.area_m2) / 24.0));
  return options;
}

/// One vector of places moved by less than this share of a cell has not moved.
constexpr double kStill = 0.02;

bool moved(const Polyline& before, const Polyline& after, double cell_m) {
  if (before.size() != after.size()) return true;
  for (size_t i = 0; i < before.size(); ++i)
    if (std::hypot(before[i].x - after[i].x, before[i].y - after[i].y) > kStill * cell_m) return true;
  return false;
}

/// Living objects of one class, fitted again.
class Refit {
 public:
  Refit(Scene& scene, const Rules& rules, const Environment& environment, int of_class, std::vector<size_t> objects,
        const RunContext& run)
      : scene_(scene),
        of_(class_at(scene, of_class)),
        cell_m_(environment.frame.cell_m),
        fitting_(scene, rules, environment, of_class, run),
        objects_(std::move(objects)),
        run_(run) {}

  bool fit() {
    if (of_.skeleton == SkeletonKind::point) return climb();
    // Where each sees another field each is fitted alone, to the others as they were.
    if (!fitting_.differs()) return fit_together(objects_, kNobody);
    bool any = false;
    for (const size_t i : objects_) any |= fit_together({i}, static_cast<int32_t>(i));
    return any;
  }

 private:
  double age(size_t i) const { return iterations_in(scene_, scene_.objects[i].window) - scene_.objects[i].born; }

  bool climb() {
    std::vector<Vec2> places;
    std::vector<int32_t> selves;
    std::vector<double> ages;
    std::vector<size_t> free;
    for (const size_t i : objects_) {
      const Skeleton& skeleton = scene_.objects[i].skeleton;
      if (!skeleton.hold.empty() && skeleton.hold[0] >= 1.0F) continue;
      free.push_back(i);
      places.push_back(skeleton.points[0]);
      selves.push_back(static_cast<int32_t>(i));
      ages.push_back(age(i));
    }
    geom::ClimbOptions options = climb_options(of_, cell_m_);
    options.steps = std::min(options.steps, 1);
    const std::vector<geom::Climbed> climbed = geom::hill_climb(places, options, fitting_.seen_by(selves, ages), run_);
    bool any = false;
    for (size_t k = 0; k < free.size(); ++k) {
      Skeleton& skeleton = scene_.objects[free[k]].skeleton;
      const double share = skeleton.hold.empty() ? 1.0 : 1.0 - skeleton.hold[0];
      const Vec2 to = places[k] + share * (climbed[k].at - places[k]);
      if (!moved({places[k]}, {to}, cell_m_)) continue;
      skeleton.points[0] = to;
      any = true;
    }
    return any;
  }

  bool fit_together(const std::vector<size_t>& objects, int32_t self) {
    const geom::FieldAtPlaces field = fitting_.seen_by(self, age(objects[0]));
    std::vector<Skeleton> fitted;
    if (of_.skeleton == SkeletonKind::curve) {
      std::vector<geom::SnakeCurve> curves;
      curves.reserve(objects.size());
      for (const size_t i : objects)
        curves.push_back({scene_.objects[i].skeleton, of_.shape.length_m * scene_.objects[i].size});
      for (geom::SnakeFit& fit : geom::fit_snakes(curves, snake_options(of_), field, run_))
        fitted.push_back(std::move(fit.skeleton));
    } else {
      std::vector<geom::RegionOutlineToFit> outlines;
      outlines.reserve(objects.size());
      for (const size_t i : objects)
        outlines.push_back({scene_.objects[i].skeleton, of_.shape.area_m2 * scene_.objects[i].size});
      for (geom::RegionFit& fit : geom::fit_regions(outlines, region_options(of_, cell_m_), field, run_))
        fitted.push_back(std::move(fit.skeleton));
    }
    bool any = false;
    for (size_t k = 0; k < objects.size(); ++k) {
      Skeleton& skeleton = scene_.objects[objects[k]].skeleton;
      if (fitted[k].points.empty() || !moved(skeleton.points, fitted[k].points, cell_m_)) continue;
      skeleton = std::move(fitted[k]);
      any = true;
    }
    return any;
  }

  Scene& scene_;
  const ObjectClass& of_;
  double cell_m_;
  Fitting fitting_;
  std::vector<size_t> objects_;
  const RunContext& run_;
};

bool wholly_held(const Skeleton& skeleton) {
  return !skeleton.hold.empty() &&
         std::all_of(skeleton.hold.begin(), skeleton.hold.end(), [](float h) { return h >= 1.0F; });
}

}  // namespace

std::vector<Skeleton> first_skeletons(const Scene& scene, const Rules& rules, const Environment& environment,
                                      int of_class, std::span<const Vec2> places, std::span<const double> sizes,
                                      const RunContext& run) {
  const ObjectClass& of = class_at(scene, of_class);
  const Fitting fitting(scene, rules, environment, of_class, run);
  const geom::FieldAtPlaces field = fitting.seen_by(kNobody, 0.0);
  std::vector<Skeleton> made;
  if (of.skeleton == SkeletonKind::point) {
    const std::vector<geom::Climbed> climbed =
        geom::hill_climb(places, climb_options(of, environment.frame.cell_m), field, run);
    for (const geom::Climbed& point : climbed) made.push_back({SkeletonKind::point, {point.at}});
  } else if (of.skeleton == SkeletonKind::curve) {
    std::vector<geom::SnakeSeed> seeds;
    for (size_t i = 0; i < places.size(); ++i) seeds.push_back({places[i], of.shape.length_m * sizes[i]});
    for (geom::SnakeFit& fit : geom::grow_snakes(seeds, snake_options(of), field, run))
      made.push_back(std::move(fit.skeleton));
  } else {
    std::vector<geom::RegionSeed> seeds;
    for (size_t i = 0; i < places.size(); ++i) seeds.push_back({places[i], of.shape.area_m2 * sizes[i]});
    for (geom::RegionFit& fit : geom::grow_regions(seeds, region_options(of, environment.frame.cell_m), field, run))
      made.push_back(std::move(fit.skeleton));
  }
  return made;
}

bool fit_again(Scene& scene, const Rules& rules, const Environment& environment, int window, const RunContext& run) {
  std::vector<std::vector<size_t>> of_class(scene.catalogue.classes.size());
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    if (object.window == window && object.born < iterations_in(scene, window) && !wholly_held(object.skeleton))
      of_class[static_cast<size_t>(object.of_class)].push_back(i);
  }
  bool any = false;
  for (size_t c = 0; c < of_class.size(); ++c) {
    if (of_class[c].empty() || scene.catalogue.classes[c].shape.steps == 0) continue;
    any |= Refit(scene, rules, environment, static_cast<int>(c), std::move(of_class[c]), run).fit();
  }
  return any;
}

}  // namespace seamount::ecosystem

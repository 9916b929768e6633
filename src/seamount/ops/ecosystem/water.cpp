#include "seamount/ops/ecosystem/water.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/current/diverted_current.h"
#include "seamount/geom/current/kelvinlet_sum.h"
#include "seamount/geom/current/object_flow.h"
#include "seamount/ops/ecosystem/events.h"

namespace seamount::ecosystem {
namespace {

VectorField simulated(const Surroundings& water, const ScalarField& height, const RunContext& run) {
  const double angle = water.towards_deg * std::numbers::pi / 180.0;
  geom::DiversionOptions options;
  options.base_m_s = water.current_m_s * Vec2{std::cos(angle), std::sin(angle)};
  options.venturi_per_m = water.venturi_1_m;
  options.scales = {{water.broad_m, water.broad_weight, water.broad_deviation},
                    {water.fine_m, water.fine_weight, water.fine_deviation}};
  options.shallows_m = water.shore_m;
  return geom::diverted_current(height, options, run);
}

void add(const VectorField& other, VectorField& current) {
  for (size_t i = 0; i < current.x.size(); ++i) {
    current.x.cells()[i] += other.x.cells()[i];
    current.y.cells()[i] += other.y.cells()[i];
  }
}

/// The primitives of objects, sorted by how they are added.
class Primitives {
 public:
  /// `before`: the current that objects find, which says what is downstream.
  explicit Primitives(const VectorField& before) : before_(before) {}

  void add(const SceneObject& object, const ObjectClass& of) {
    for (const CurrentEffect& effect : of.currents) {
      if (of.skeleton == SkeletonKind::point) {
        add_point(object.skeleton.points[0], object.size, effect);
      } else if (of.skeleton == SkeletonKind::curve) {
        const bool grab = effect.shape == CurrentShape::grab;
        curves.push_back(
            {object.skeleton.points, effect.radius_m, grab ? effect.speed_m_s : 0.0, grab ? 0.0 : effect.speed_m_s});
      } else {
        const bool waves = effect.shape == CurrentShape::waves;
        regions.push_back({{object.skeleton.points, {}},
                           effect.radius_m,
                           waves ? 0.0 : effect.speed_m_s,
                           waves ? effect.speed_m_s : 0.0});
      }
    }
  }

  std::vector<geom::Kelvinlet> kelvinlets;
  std::vector<geom::CurveFlow> curves;
  std::vector<geom::RegionFlow> regions;

 private:
  void add_point(Vec2 at, double size, const CurrentEffect& effect) {
    const Vec2 downstream = direction(at);
    const Vec2 left{-downstream.y, downstream.x};
    geom::Kelvinlet made;
    made.kind = static_cast<geom::KelvinletKind>(effect.shape);
    made.centre = at + size * (effect.downstream_m * downstream + effect.left_m * left);
    made.radius_m = size * effect.radius_m;
    made.speed_m_s = effect.shape == CurrentShape::grab ? effect.speed_m_s * downstream : Vec2{effect.speed_m_s, 0.0};
    made.poisson_ratio = effect.poisson_ratio;
    kelvinlets.push_back(made);
  }

  Vec2 direction(Vec2 at) const {
    const GridFrame& frame = before_.frame();
    const int x = std::clamp(static_cast<int>(std::lround(frame.column(at.x))), 0, frame.width - 1);
    const int y = std::clamp(static_cast<int>(std::lround(frame.row(at.y))), 0, frame.height - 1);
    const Vec2 v{before_.x(x, y), before_.y(x, y)};
    const double speed = std::hypot(v.x, v.y);
    return speed > 0.0 ? (1.0 / speed) * v : Vec2{1.0, 0.0};
  }

  const VectorField& before_;
};

/// Over dry land nothing flows: the current fades out from a depth of `shore_m` to none.
void stop_at_shore(const ScalarField& height, double shore_m, VectorField& current, const RunContext& run) {
  if (shore_m <= 0.0) return;
  const auto per_m = static_cast<float>(1.0 / shore_m);
  parallel_rows(run, height.width(), height.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < height.width(); ++x) {
        const float share = std::clamp(-height(x, y) * per_m, 0.0F, 1.0F);
        current.x(x, y) *= share;
        current.y(x, y) *= share;
      }
    }
  });
}

}  // namespace

VectorField current_of(const Scene& scene, const Site& site, const ScalarField& height, int window, double time,
                       const VectorField* around, const RunContext& run) {
  VectorField current = around != nullptr ? *around : simulated(scene.surroundings, height, run);
  if (around == nullptr) {
    if (site.current != nullptr) add(*site.current, current);
    add_event_currents(scene.timeline, time, current, run);
  }
  Primitives primitives(current);
  for (const SceneObject& object : scene.objects)
    if (object.window == window) primitives.add(object, scene.catalogue.classes[static_cast<size_t>(object.of_class)]);
  const bool none = primitives.kelvinlets.empty() && primitives.curves.empty() && primitives.regions.empty();
  geom::add_kelvinlets(primitives.kelvinlets, current, run);
  geom::add_curve_flow(primitives.curves, current, run);
  geom::add_region_flow(primitives.regions, current, run);
  if (around == nullptr || !none) stop_at_shore(height, scene.surroundings.shore_m, current, run);
  return current;
}

}  // namespace seamount::ecosystem

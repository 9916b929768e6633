#include "seamount/ops/ecosystem/ground.h"

#include <algorithm>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/skeleton/height_proxy.h"
#include "seamount/ops/ecosystem/events.h"

namespace seamount::ecosystem {
namespace {

/// The height function of an object: of points as large as they are.
HeightEffect effect_of(const SceneObject& object, const ObjectClass& of) {
  HeightEffect effect = of.height;
  if (of.skeleton != SkeletonKind::point) return effect;
  effect.width_m *= object.size;
  effect.roughness_m *= object.size;
  if (effect.group == HeightGroup::surface) effect.height_m *= object.size;
  return effect;
}

HeightField ground_of(const Scene& scene, const Site& site, int window, const RunContext& run) {
  if (window == 0) return site.ground;
  return geom::resample(site.ground, frame_of(scene, window), run);
}

}  // namespace

HeightField ground_with_objects(const Scene& scene, const Site& site, int window, double time, double water_level_m,
                                const RunContext& run) {
  HeightField ground = ground_of(scene, site, window, run);
  add_ground_events(scene.timeline, time, ground, run);
  std::vector<Skeleton> skeletons;
  std::vector<HeightEffect> effects;
  for (const SceneObject& object : scene.objects) {
    const ObjectClass& of = scene.catalogue.classes[static_cast<size_t>(object.of_class)];
    if (of.height.shape == HeightShape::none || !seen_from(scene, object, window)) continue;
    HeightEffect effect = effect_of(object, of);
    if (of.skeleton == SkeletonKind::point && effect.width_m < ground.cell_m()) continue;
    skeletons.push_back(object.skeleton);
    effects.push_back(effect);
  }
  if (skeletons.empty()) return ground;
  const auto lowest = std::min_element(site.ground.cells().begin(), site.ground.cells().end());
  const geom::ProxyGround shared{*lowest, water_level_m, scene.surroundings.blend_m};
  return geom::HeightProxies(skeletons, effects, shared).over(ground, run);
}

}  // namespace seamount::ecosystem

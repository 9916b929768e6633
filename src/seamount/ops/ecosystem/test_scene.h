// Small catalogues and scenes for tests.
#pragma once

#include <string>
#include <utility>

#include "seamount/geom/scalar/noise.h"
#include "seamount/model/scene.h"
#include "seamount/ops/ecosystem/grow.h"

namespace seamount::ecosystem {

inline Material material(std::string name) {
  Material made;
  made.name = std::move(name);
  return made;
}

inline ObjectClass object_class(std::string name, SkeletonKind skeleton, std::string fitness) {
  ObjectClass made;
  made.name = std::move(name);
  made.skeleton = skeleton;
  made.fitness = std::move(fitness);
  return made;
}
inline ObjectClass point(std::string name, std::string fitness) {
  return object_class(std::move(name), SkeletonKind::point, std::move(fitness));
}
inline ObjectClass curve(std::string name, std::string fitness) {
  return object_class(std::move(name), SkeletonKind::curve, std::move(fitness));
}
inline ObjectClass region(std::string name, std::string fitness) {
  return object_class(std::move(name), SkeletonKind::region, std::move(fitness));
}

/// Still water over nothing but what the test adds.
inline Scene still_scene(const GridFrame& frame) {
  Scene scene;
  scene.frame = frame;
  scene.surroundings.current_m_s = 0.0;
  scene.seed = 5;
  return scene;
}

inline void add_object(Scene& scene, int of_class, Polyline points) {
  const SkeletonKind kind = scene.catalogue.classes[static_cast<size_t>(of_class)].skeleton;
  scene.objects.push_back({.id = scene.next_id++, .of_class = of_class, .skeleton = {kind, std::move(points)}});
}

/// A slope from 20 m under water in the west to 20 m over it in the east, with hills.
inline HeightField shore(int cells = 64, double cell_m = 10.0) {
  const GridFrame frame = GridFrame::centred(cells, cells, cell_m);
  HeightField ground = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 200.0, .octaves = 4}, {});
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x)
      ground(x, y) = static_cast<float>(10.0 * ground(x, y) + 40.0 * frame.x(x) / frame.width_m());
  return ground;
}

/// Corals under water that deposit what algae live of; a reef along the corals.
inline Catalogue small_catalogue() {
  Catalogue catalogue;
  catalogue.materials = {material("lime")};
  catalogue.materials[0].diffusivity_m2_s = 4.0;
  catalogue.classes = {point("coral", "bell(depth, 6, 3)"), point("alga", "lime - 0.02 * distance(alga) / 100")};
  ObjectClass& coral = catalogue.classes[0];
  coral.birth = 0.5;
  coral.death = 0.3;
  coral.placement.per_iteration = 20;
  coral.placement.spacing_m = 15.0;
  coral.deposits = {{"lime", 0.1, 20.0}};
  ObjectClass& alga = catalogue.classes[1];
  alga.birth = 0.05;
  alga.placement.per_iteration = 10;
  alga.placement.spacing_m = 8.0;
  return catalogue;
}

inline GrowParams some(int iterations) {
  GrowParams params;
  params.iterations = iterations;
  return params;
}

inline Grown grown(const HeightField& ground, const Catalogue& catalogue, const GrowParams& params, uint64_t seed = 7,
                   const RunContext& run = {}) {
  return grow({ground, &catalogue}, params, Seed{seed}, run);
}

inline int count(const Scene& scene, const std::string& name) {
  int n = 0;
  for (const SceneObject& object : scene.objects)
    n += scene.catalogue.classes[static_cast<size_t>(object.of_class)].name == name;
  return n;
}

}  // namespace seamount::ecosystem

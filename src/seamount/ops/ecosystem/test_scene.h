// Small catalogues and scenes for tests.
#pragma once

#include <string>
#include <utility>

#include "seamount/model/scene.h"

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

}  // namespace seamount::ecosystem

#include "seamount/ops/ecosystem/scene_things.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/ecosystem/place_things.h"

namespace seamount::ecosystem {
namespace {

/// Gathers what stands where, class by class.
class Layout {
 public:
  Layout(const Scene& scene, const GridFrame& frame, const MeshFiles& meshes)
      : scene_(scene), frame_(frame), meshes_(meshes), first_spec_(scene.catalogue.classes.size()) {
    for (size_t c = 0; c < scene.catalogue.classes.size(); ++c) {
      first_spec_[c] = static_cast<uint32_t>(specs.size());
      const ObjectClass& of = scene.catalogue.classes[c];
      for (size_t i = 0; i < of.things.size(); ++i) add_spec(of, i);
    }
  }

  void add(const SceneObject& object) {
    const ObjectClass& of = scene_.catalogue.classes[static_cast<size_t>(object.of_class)];
    if (of.things.empty()) return;
    if (of.skeleton == SkeletonKind::point)
      return add_one(object, of, object.skeleton.points[0], object.size, object.id);
    if (of.things_spacing_m <= 0.0) return;
    if (of.skeleton == SkeletonKind::curve) return add_along(object, of);
    add_within(object, of);
  }

  std::vector<ThingSpec> specs;
  std::vector<ThingPlace> places;

 private:
  void add_spec(const ObjectClass& of, size_t i) {
    ThingSpec spec;
    spec.name = of.things.size() == 1 ? of.name : of.name + "_" + std::to_string(i + 1);
    spec.params = of.things[i];
    if (spec.params.shape == ThingForm::file) {
      const auto found = meshes_.find(spec.params.file.path);
      if (found == meshes_.end())
        throw InvalidArgument("catalogue", "the class '" + of.name + "' names the mesh file '" + spec.params.file.path +
                                               "', which was not read");
      spec.mesh = found->second;
    }
    specs.push_back(std::move(spec));
  }

  void add_one(const SceneObject& object, const ObjectClass& of, Vec2 at, double size, uint64_t key) {
    if (at.x < frame_.west_m || at.x > frame_.east_m() || at.y < frame_.south_m() || at.y > frame_.north_m) return;
    const double room = of.birth - of.death;
    const double health = room > 0.0 ? std::clamp((object.fitness - of.death) / room, 0.0, 1.0) : 1.0;
    Rng rng(Seed{scene_.seed}.derive("kind of thing", key));
    const auto kind = static_cast<uint32_t>(rng.integer(0, static_cast<int>(of.things.size()) - 1));
    places.push_back({.place = at,
                      .spec = first_spec_[static_cast<size_t>(object.of_class)] + kind,
                      .size = size,
                      .health = std::isfinite(health) ? health : 0.0,
                      .key = key});
  }

  static uint64_t key_of(const SceneObject& object, uint64_t number) {
    return mix_bits(object.id * 0x9e3779b97f4a7c15ULL + number);
  }

  void add_along(const SceneObject& object, const ObjectClass& of) {
    Rng rng(Seed{scene_.seed}.derive("things along", object.id));
    double ahead = of.things_spacing_m * rng.uniform();
    uint64_t number = 0;
    const Polyline& line = object.skeleton.points;
    for (size_t i = 1; i < line.size(); ++i) {
      const Vec2 step = line[i] - line[i - 1];
      const double length = std::hypot(step.x, step.y);
      for (; ahead < length; ahead += of.things_spacing_m * rng.uniform(0.7, 1.3))
        add_one(object, of, line[i - 1] + (ahead / length) * step, 1.0, key_of(object, ++number));
      ahead -= length;
    }
  }

  void add_within(const SceneObject& object, const ObjectClass& of) {
    const double spacing = of.things_spacing_m;
    const geom::Box box = geom::bounding_box(object.skeleton.points);
    Rng rng(Seed{scene_.seed}.derive("things within", object.id));
    uint64_t number = 0;
    for (double y = box.low.y; y < box.high.y; y += spacing) {
      for (double x = box.low.x; x < box.high.x; x += spacing) {
        const double u = rng.uniform(), v = rng.uniform();
        const Vec2 at{x + u * spacing, y + v * spacing};
        if (geom::contains(object.skeleton.points, at)) add_one(object, of, at, 1.0, key_of(object, ++number));
      }
    }
  }

  const Scene& scene_;
  const GridFrame& frame_;
  const MeshFiles& meshes_;
  std::vector<uint32_t> first_spec_;
};

}  // namespace

Things things(const Scene& scene, const HeightField& surface, const MeshFiles& meshes, const ThingsParams& params,
              const RunContext& run) {
  check_params(params);
  Layout layout(scene, frame_of(scene, params.window), meshes);
  for (const SceneObject& object : scene.objects) layout.add(object);
  PlaceThingsOptions options;
  options.max_triangles = static_cast<uint64_t>(params.max_triangles);
  options.keep_ground = params.keep_ground;
  return place_things(surface, layout.specs, layout.places, options, Seed{scene.seed}.derive("things"), run);
}

}  // namespace seamount::ecosystem

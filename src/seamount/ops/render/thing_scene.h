// Things in a perspective picture: rays meet a tree of instances, and in each the tree of its model (two levels, as in
// Parker et al., "OptiX", 2010); all instances of a model share its triangles.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "seamount/geom/mesh/mesh_tracer.h"
#include "seamount/model/things.h"
#include "seamount/ops/render/camera.h"
#include "seamount/ops/render/ground.h"

namespace seamount::render {

struct ThingHit {
  float t = 0.0F;  ///< metres along the ray
  uint32_t instance = 0, triangle = 0;
  float u = 0.0F, v = 0.0F;
};

/// Where a ray met a thing.
struct ThingSurface {
  Vec3 normal;   ///< for shading, unit length
  Vec3 lift;     ///< from the triangle to the curved surface that it stands for: where rays to lights start
  Vec3 outside;  ///< of the triangle itself, towards the ray's origin
  Rgb albedo;
  bool leaf = false;  ///< thin: light shines through
};

/// From where they are drawn.
struct ThingView {
  Vec3 eye;
  float pixel_angle = 0.001F;  ///< radians
  double water_level_m = 0.0;
  double exaggeration = 1.0;  ///< of the ground's heights, not of the things
};

class ThingScene {
 public:
  /// Places are relative to the terrain's middle; feet follow the ground as it is drawn (reduced, exaggerated), which
  /// may differ from `terrain`. Models are drawn in the level that their size in the picture asks for, never finer than
  /// their own. Keeps a reference to the things. About 1 us a thing and 0.3 ms a model, twice their memory.
  ThingScene(const Things& things, const HeightField& terrain, const Ground& ground, const ThingView& view,
             const RunContext& run);

  bool empty() const { return instances_.empty(); }
  /// The mean height of things, metres: how far they keep light from the ground around them.
  float reach() const { return reach_; }

  /// The first thing on the ray in (begin, end).
  std::optional<ThingHit> hit(Vec3 from, Vec3 direction, float begin, float end) const;
  bool blocked(Vec3 from, Vec3 direction, float begin, float end) const;
  /// Whether a ray that is `wide` metres wide comes near a thing before `end`: a pixel there needs a closer look.
  bool near(Vec3 from, Vec3 direction, float end, float wide) const;
  ThingSurface surface(const ThingHit& hit, Vec3 direction) const;

 private:
  struct Instance {
    std::array<float, 9> inward;  ///< rows: from the world's directions to the model's, divided by the scale
    Vec3 foot;
    float tint;
    uint32_t thing, model;
  };
  struct Model {
    const ThingMesh* mesh = nullptr;
    geom::MeshTracer tracer;
  };
  geom::Ray3 inside(const Instance& instance, Vec3 from, Vec3 direction, float begin) const;
  void add_models(const RunContext& run);
  uint32_t level_of(const Thing& thing, Vec3 foot, const ThingView& view) const;

  const Things& things_;
  std::vector<Model> models_;
  std::vector<uint32_t> first_model_;  ///< of each shape
  std::vector<Instance> instances_;
  geom::Bvh tree_;
  float reach_ = 1.0F;
};

}  // namespace seamount::render

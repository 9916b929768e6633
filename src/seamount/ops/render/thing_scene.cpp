#include "seamount/ops/render/thing_scene.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/model/sample_known.h"

namespace seamount::render {
namespace {

constexpr float kFinePx = 26.0F, kMiddlePx = 7.0F;  // height in the picture from which levels 0 and 1 are drawn

std::array<float, 3> array_of(Vec3 v) { return {v.x, v.y, v.z}; }

Vec3 row(const std::vector<float>& values, size_t i) { return {values[3 * i], values[3 * i + 1], values[3 * i + 2]}; }

Vec3 crossed(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// Columns of a rotation.
std::array<float, 9> rotation_of(const std::array<float, 4>& q) {
  std::array<float, 9> columns{};
  for (size_t axis = 0; axis < 3; ++axis) {
    std::array<double, 3> unit{};
    unit[axis] = 1.0;
    const auto image = turned(q, unit);
    for (size_t k = 0; k < 3; ++k) columns[3 * axis + k] = static_cast<float>(image[k]);
  }
  return columns;
}

/// The model's box as it stands in the world.
geom::Box3 standing(const geom::Box3& box, const std::array<float, 9>& inward, float scale, Vec3 foot) {
  geom::Box3 world;
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::array<float, 3> p{};
    for (size_t axis = 0; axis < 3; ++axis) {
      const float at = scale * scale * ((corner >> axis & 1U) != 0 ? box.high[axis] : box.low[axis]);
      for (size_t k = 0; k < 3; ++k) p[k] += inward[3 * axis + k] * at;
    }
    world.include(std::array{p[0] + foot.x, p[1] + foot.y, p[2] + foot.z});
  }
  return world;
}

}  // namespace

ThingScene::ThingScene(const Things& things, const HeightField& terrain, const Ground& ground, const ThingView& view,
                       const RunContext& run)
    : things_(things) {
  add_models(run);
  const GridFrame& frame = terrain.frame();
  const double middle_x = frame.west_m + 0.5 * frame.width_m(), middle_y = frame.north_m - 0.5 * frame.height_m();
  instances_.resize(things.things.size());
  std::vector<geom::Box3> boxes(instances_.size());
  constexpr int64_t kGrain = 1024;
  parallel_blocks(run, static_cast<int64_t>(instances_.size()), kGrain, [&](int64_t begin, int64_t end) {
    for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
      const Thing& thing = things.things[i];
      Instance& made = instances_[i];
      made.foot = {static_cast<float>(thing.place.x - middle_x), static_cast<float>(thing.place.y - middle_y), 0.0F};
      const double at = sample_known(terrain, frame.column(thing.place.x), frame.row(thing.place.y));
      const double drawn = sample_known(ground.heights(), ground.column(made.foot.x), ground.row(made.foot.y));
      made.foot.z =
          static_cast<float>(std::isnan(at) || std::isnan(drawn) ? (thing.z_m - view.water_level_m) * view.exaggeration
                                                                 : drawn + (thing.z_m - at));
      made.inward = rotation_of(thing.rotation);
      for (float& value : made.inward) value /= thing.scale;
      made.tint = thing.tint;
      made.thing = static_cast<uint32_t>(i);
      made.model = first_model_[thing.shape] + level_of(thing, made.foot, view);
      boxes[i] = standing(models_[made.model].tracer.bounds(), made.inward, thing.scale, made.foot);
    }
  });
  tree_ = geom::Bvh(boxes, 1);
  double height = 0.0;
  for (const Thing& thing : things.things) height += thing.scale * things.shapes[thing.shape].height_m;
  if (!things.things.empty()) reach_ = static_cast<float>(height / static_cast<double>(things.things.size()));
}

void ThingScene::add_models(const RunContext& run) {
  for (const ThingShape& shape : things_.shapes) {
    first_model_.push_back(static_cast<uint32_t>(models_.size()));
    for (const ThingMesh& mesh : shape.levels) models_.push_back({&mesh, {}});
  }
  parallel_blocks(run, static_cast<int64_t>(models_.size()), 1, [&](int64_t begin, int64_t) {
    Model& model = models_[static_cast<size_t>(begin)];
    model.tracer = geom::MeshTracer(model.mesh->positions, model.mesh->indices);
  });
}

uint32_t ThingScene::level_of(const Thing& thing, Vec3 foot, const ThingView& view) const {
  const ThingShape& shape = things_.shapes[thing.shape];
  const Vec3 way = foot - view.eye;
  const float distance = std::sqrt(dot(way, way));
  const float pixels =
      thing.scale * std::max(shape.height_m, shape.radius_m) / std::max(1e-3F, distance * view.pixel_angle);
  const uint32_t wanted = pixels > kFinePx ? 0 : pixels > kMiddlePx ? 1 : 2;
  return std::min(std::max(wanted, thing.level), static_cast<uint32_t>(shape.levels.size() - 1));
}

geom::Ray3 ThingScene::inside(const Instance& instance, Vec3 from, Vec3 direction, float begin) const {
  const Vec3 way = from - instance.foot;
  geom::Ray3 ray;
  ray.begin = begin;
  for (size_t axis = 0; axis < 3; ++axis) {
    const Vec3 inward{instance.inward[3 * axis], instance.inward[3 * axis + 1], instance.inward[3 * axis + 2]};
    ray.from[axis] = dot(inward, way);
    ray.direction[axis] = dot(inward, direction);
  }
  return ray;
}

std::optional<ThingHit> ThingScene::hit(Vec3 from, Vec3 direction, float begin, float end) const {
  ThingHit nearest;
  bool found = false;
  tree_.traverse({array_of(from), array_of(direction), begin}, end, 0.0F, [&](uint32_t i, float until) {
    const uint32_t number = tree_.order()[i];
    const Instance& instance = instances_[number];
    const auto met = models_[instance.model].tracer.first(inside(instance, from, direction, begin), until);
    if (!met) return until;
    nearest = {met->t, number, met->triangle, met->u, met->v};
    found = true;
    return met->t;
  });
  return found ? std::optional(nearest) : std::nullopt;
}

bool ThingScene::blocked(Vec3 from, Vec3 direction, float begin, float end) const {
  bool found = false;
  tree_.traverse({array_of(from), array_of(direction), begin}, end, 0.0F, [&](uint32_t i, float until) {
    const Instance& instance = instances_[tree_.order()[i]];
    found = models_[instance.model].tracer.any(inside(instance, from, direction, begin), until);
    return found ? begin - 1.0F : until;
  });
  return found;
}

bool ThingScene::near(Vec3 from, Vec3 direction, float end, float wide) const {
  bool found = false;
  tree_.traverse({array_of(from), array_of(direction), 0.0F}, end, wide, [&](uint32_t, float) {
    found = true;
    return -1.0F;
  });
  return found;
}

ThingSurface ThingScene::surface(const ThingHit& hit, Vec3 direction) const {
  const Instance& instance = instances_[hit.instance];
  const ThingMesh& mesh = *models_[instance.model].mesh;
  const float scale = things_.things[instance.thing].scale;
  const size_t at = 3 * size_t{hit.triangle};
  const std::array<size_t, 3> corners = {mesh.indices[at], mesh.indices[at + 1], mesh.indices[at + 2]};
  const std::array<float, 3> weights = {1.0F - hit.u - hit.v, hit.u, hit.v};
  Vec3 normal;
  Rgb albedo;
  for (size_t k = 0; k < 3; ++k) {
    normal = normal + weights[k] * row(mesh.normals, corners[k]);
    albedo += weights[k] * linear(mesh.colours[corners[k]]);
  }
  const auto outward = [&](Vec3 n) {  // the columns of inward are rows of the rotation
    const auto& m = instance.inward;
    return scale * Vec3{m[0] * n.x + m[3] * n.y + m[6] * n.z, m[1] * n.x + m[4] * n.y + m[7] * n.z,
                        m[2] * n.x + m[5] * n.y + m[8] * n.z};
  };
  const Vec3 a = row(mesh.positions, corners[0]);
  Vec3 face = normalised(outward(crossed(row(mesh.positions, corners[1]) - a, row(mesh.positions, corners[2]) - a)));
  if (dot(face, direction) > 0.0F) face = -1.0F * face;
  ThingSurface made;
  made.leaf = at >= mesh.solid;
  made.normal = normalised(outward(normal));
  // Surfaces are seen from outside; of a leaf the side that is seen counts, unless its normal is the crown's.
  constexpr float kAside = -0.3F;
  if (dot(made.normal, face) < (made.leaf ? kAside : 0.0F)) made.normal = -1.0F * made.normal;
  made.outside = face;
  // Colours of catalogues are as they look; surfaces send back about two thirds of that.
  constexpr float kAlbedo = 0.62F;
  made.albedo = (kAlbedo * instance.tint) * albedo;
  if (made.leaf) return made;
  // Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, 2021: no facets where light grazes.
  Vec3 at_hit;
  for (size_t k = 0; k < 3; ++k) at_hit = at_hit + weights[k] * row(mesh.positions, corners[k]);
  Vec3 lift;
  for (size_t k = 0; k < 3; ++k) {
    const Vec3 n = row(mesh.normals, corners[k]);
    const float below = std::min(0.0F, dot(at_hit - row(mesh.positions, corners[k]), n));
    lift = lift - (weights[k] * below) * n;
  }
  made.lift = scale * outward(lift);
  return made;
}

}  // namespace seamount::render

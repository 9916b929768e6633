// The world of a perspective picture: what a ray meets and what colour that is.
#pragma once

#include "seamount/ops/render/ground.h"
#include "seamount/ops/render/sky.h"
#include "seamount/ops/render/tracer.h"

namespace seamount::render {

/// What a ray meets first.
enum class Surface : unsigned char { sky, land, sea, wall, water_wall, table };

struct Hit {
  Surface surface = Surface::sky;
  float t = 0.0F;  ///< metres along the ray
};

struct SceneOptions {
  bool water = true;
  bool sea = true;  ///< the water goes on beyond the terrain; otherwise a block on a table
  float clarity = 1.0F;
  float haze = 1.0F;
  MaterialRules rules;
};

class Scene {
 public:
  /// Keeps a reference to the ground.
  Scene(const Ground& ground, const Sky& sky, const SceneOptions& options, const RunContext& run);

  Hit hit(Vec3 from, Vec3 direction) const;
  /// Scene light towards the eye. `pixel_angle` in radians is what the ray stands for.
  Rgb light(Vec3 from, Vec3 direction, Hit hit, float pixel_angle) const;
  /// Height of the table under a block.
  float base() const { return base_; }

 private:
  Rgb surface_light(Vec3 from, Vec3 direction, Hit hit, float pixel_angle) const;
  Rgb land_light(Vec3 place, Vec3 direction, float footprint) const;
  Rgb sea_light(Vec3 place, Vec3 direction, float footprint) const;
  /// Share of the water's surface that is foam.
  float foam(Vec3 place, float footprint, float depth) const;
  Rgb wall_light(Vec3 place, float footprint) const;
  Rgb water_wall_light(Vec3 place, Vec3 direction, float footprint) const;
  Rgb table_light(Vec3 place) const;
  /// Share of the sun that the block leaves for a place on the table.
  float table_sun(Vec3 place) const;
  /// Where a ray that enters the water meets the floor, or where it is too deep to be seen.
  Vec3 refracted_floor(Vec3 place, Vec3 direction) const;
  float beyond(float x, float y) const;
  LatticeRay lattice_ray(Vec3 from, Vec3 direction, float start) const;
  Vec3 wall_normal(Vec3 place) const;

  const Ground& ground_;
  const Sky& sky_;
  SceneOptions options_;
  Tracer tracer_;
  Haze haze_;
  float base_ = 0.0F;
};

}  // namespace seamount::render

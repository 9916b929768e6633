// The world of a perspective picture: what a ray meets and what colour that is.
#pragma once

#include "seamount/ops/render/ground.h"
#include "seamount/ops/render/sky.h"
#include "seamount/ops/render/thing_scene.h"
#include "seamount/ops/render/tracer.h"

namespace seamount::render {

/// What a ray meets first.
enum class Surface : unsigned char {
  sky,
  land,
  sea,
  wall,
  water_wall,
  table,
  thing,
  underside,  ///< of the water's surface
  deep,       ///< water without end
};

struct Hit {
  Surface surface = Surface::sky;
  float t = 0.0F;  ///< metres along the ray
  ThingHit thing = {};
};

/// Light at a place: of the air, or what comes down through the water.
struct Lamp {
  Vec3 to_sun;
  Rgb sun, sky;
};

/// Numbers in [0, 1) for a ray's own soft shadows.
struct Dice {
  float sun_u = 0.5F, sun_v = 0.5F, sky_u = 0.5F, sky_v = 0.5F;
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

  /// What stands on the ground too, and must stay. Before anything is drawn.
  void add_things(const ThingScene* things) { things_ = things; }
  const ThingScene* things() const { return things_; }
  /// The eye is under water: rays from there meet the floor, the surface from below, or water without end.
  void submerge() { submerged_ = true; }

  Hit hit(Vec3 from, Vec3 direction) const;
  /// Scene light towards the eye. `pixel_angle` in radians is what the ray stands for.
  Rgb light(Vec3 from, Vec3 direction, Hit hit, float pixel_angle, Dice dice = {}) const;
  /// Whether a thing keeps the middle of the sun from a place.
  bool shaded(Vec3 place) const;
  /// Height of the table under a block.
  float base() const { return base_; }

 private:
  Hit ground_hit(Vec3 from, Vec3 direction) const;
  /// The same with water wherever the ground lies lower.
  Hit over_water_hit(Vec3 from, Vec3 direction) const;
  Hit submerged_hit(Vec3 from, Vec3 direction) const;
  Rgb submerged_light(Vec3 from, Vec3 direction, const Hit& hit, float pixel_angle, Dice dice) const;
  /// What water sends towards the eye along a ray of that length, of its own.
  Rgb water_glow(Vec3 from, Vec3 direction, float length) const;
  /// The water's surface from below: the sky in Snell's window, else the mirrored floor.
  Rgb underside_light(Vec3 place, Vec3 direction, float footprint) const;
  Lamp lamp(Vec3 place) const;
  float caustics(Vec3 place, float footprint) const;
  Rgb surface_light(Vec3 from, Vec3 direction, Hit hit, float pixel_angle, Dice dice) const;
  Rgb land_light(Vec3 place, Vec3 direction, float footprint, Dice dice) const;
  Rgb thing_light(Vec3 place, Vec3 direction, const ThingHit& hit, float footprint, Dice dice) const;
  /// How much sun a place on a thing sends back, by its slope and what is in the way.
  float sun_on_thing(const ThingSurface& surface, Vec3 place, Vec3 to_sun, Dice dice) const;
  /// Shares of the sun and of the sky that things leave to a place with that normal.
  float sun_past_things(Vec3 place, Vec3 to_sun, Dice dice) const;
  float sky_past_things(Vec3 place, Vec3 normal, Dice dice) const;
  float sun_past_ground(Vec3 place, Vec3 to_sun) const;
  float beside_surface(Vec3 place) const;
  Rgb river_light(Vec3 place, Vec3 direction, float footprint, const GroundSample& ground, Dice dice) const;
  Rgb lake_light(Vec3 place, Vec3 direction, float footprint, const GroundSample& ground, Dice dice) const;
  Rgb sea_light(Vec3 place, Vec3 direction, float footprint, Dice dice) const;
  /// What things under water change of a view down through the surface: the floor that is seen, its depth.
  void see_things_below(Vec3 surface, Vec3 floor, float& depth, Rgb& albedo, Dice dice) const;
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
  float border_depth_ = 0.0F;  ///< metres of water at the terrain's border, on the mean
  const ThingScene* things_ = nullptr;
  bool submerged_ = false;
};

}  // namespace seamount::render

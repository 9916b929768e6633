#include "seamount/ops/ecosystem/place_things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/things/make_thing.h"
#include "seamount/model/sample_known.h"
#include "seamount/ops/ecosystem/thing_budget.h"

namespace seamount::ecosystem {
namespace {

constexpr int kHealths = 5;  // steps of health that have models of their own

struct ShapeKey {
  uint32_t spec;
  int variant, health;
  auto operator<=>(const ShapeKey&) const = default;
};

ShapeKey shape_of(const ThingPlace& p, const ThingSpec& spec, Seed seed) {
  Rng rng(seed.derive("variant", p.key));
  const int count = spec.params.shape == ThingForm::file ? 1 : spec.params.variants;
  return {p.spec, rng.integer(0, count - 1), static_cast<int>(std::lround(p.health * (kHealths - 1)))};
}

void check(const std::vector<ThingSpec>& specs, const std::vector<ThingPlace>& placements) {
  for (size_t i = 0; i < specs.size(); ++i) {
    const std::string place = "specs[" + std::to_string(i) + "].";
    check_params(specs[i].params, place);
    if (specs[i].params.shape == ThingForm::file && !specs[i].mesh)
      throw InvalidArgument(place + "mesh", "shape file needs the mesh of a file");
  }
  for (size_t i = 0; i < placements.size(); ++i) {
    const ThingPlace& p = placements[i];
    const auto fail = [&](const std::string& problem) {
      throw InvalidArgument("placements", std::to_string(i) + ": " + problem);
    };
    if (p.spec >= specs.size()) fail("spec " + std::to_string(p.spec) + " of " + std::to_string(specs.size()));
    if (!(p.size > 0.0 && std::isfinite(p.size))) fail("size " + format_number(p.size) + " is not above 0");
    if (!(p.health >= 0.0 && p.health <= 1.0)) fail("health " + format_number(p.health) + " is outside [0, 1]");
    if (!std::isfinite(p.place.x) || !std::isfinite(p.place.y)) fail("its place is no number");
    if (p.heading_deg && !std::isfinite(*p.heading_deg)) fail("its heading is no number");
  }
}

/// Height, and slopes towards east and north; nothing where the ground is not known.
struct Footing {
  double z, east, north;
};

std::optional<Footing> footing(const HeightField& terrain, Vec2 place) {
  const GridFrame& frame = terrain.frame();
  const double column = frame.column(place.x), row = frame.row(place.y);
  const double z = sample_known(terrain, column, row);
  if (std::isnan(z)) return std::nullopt;
  constexpr double kStep = 0.5;  // of a cell to each side
  const auto slope = [&](double dc, double dr) {
    const double a = sample_known(terrain, column + dc, row + dr), b = sample_known(terrain, column - dc, row - dr);
    if (!std::isnan(a) && !std::isnan(b)) return (a - b) / (2.0 * kStep * frame.cell_m);
    if (!std::isnan(a)) return (a - z) / (kStep * frame.cell_m);
    return std::isnan(b) ? 0.0 : (z - b) / (kStep * frame.cell_m);
  };
  return Footing{z, slope(kStep, 0.0), slope(0.0, -kStep)};
}

using Quaternion = std::array<double, 4>;

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

/// Turned about its axis, then leaned from upright by `lean` of the way to the ground's normal.
std::array<float, 4> rotation(double heading, double lean, const Footing& ground) {
  const Quaternion turn = {0.0, 0.0, std::sin(-0.5 * heading), std::cos(0.5 * heading)};
  const double steep = std::hypot(ground.east, ground.north), tilt = lean * std::atan(steep);
  Quaternion all = turn;
  if (tilt > 0.0) {  // about the horizontal axis square to the fall line
    const double s = std::sin(0.5 * tilt) / steep;
    all = product({ground.north * s, -ground.east * s, 0.0, std::cos(0.5 * tilt)}, turn);
  }
  return {static_cast<float>(all[0]), static_cast<float>(all[1]), static_cast<float>(all[2]),
          static_cast<float>(all[3])};
}

/// How far the edge of a thing's foot would be above the ground if its middle stood at height z.
double gap_below(const HeightField& terrain, const Thing& thing, double foot_m, double z) {
  constexpr int kPlaces = 8;
  double gap = 0.0;
  for (int k = 0; k < kPlaces; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kPlaces, r = foot_m * thing.scale;
    const auto edge = turned(thing.rotation, {r * std::cos(angle), r * std::sin(angle), 0.0});
    const double below = sample_known(terrain, terrain.frame().column(thing.place.x + edge[0]),
                                      terrain.frame().row(thing.place.y + edge[1]));
    if (!std::isnan(below)) gap = std::max(gap, z + edge[2] - below);
  }
  return gap;
}

Thing thing_on(const HeightField& terrain, const Footing& ground, const ThingPlace& p, const ThingParams& params,
               double foot_m, double height_m, Seed seed) {
  Rng rng(seed.derive("thing", p.key));
  const geom::UsualThing usual = geom::usual(params.shape);
  const double lean = params.lean.value_or(usual.lean);
  const double random_heading = rng.uniform(0.0, 2.0 * std::numbers::pi), spread = rng.normal(), light = rng.normal();
  Thing thing;
  thing.place = p.place;
  thing.scale = static_cast<float>(p.size * std::clamp(std::exp(params.size_variation * spread), 0.4, 2.2));
  const double heading = p.heading_deg ? *p.heading_deg * std::numbers::pi / 180.0 : random_heading;
  thing.rotation = rotation(heading, lean, ground);
  thing.health = static_cast<float>(p.health);
  thing.tint = static_cast<float>(std::clamp(1.0 + 0.07 * light, 0.82, 1.18));
  const double gap = gap_below(terrain, thing, foot_m, ground.z);
  thing.z_m = ground.z - std::min(gap, 0.5 * thing.scale * height_m) - thing.scale * usual.sunk * height_m;
  return thing;
}

/// The shapes that are needed, in their keys' order, and of each placement which one it is.
struct Models {
  std::vector<ThingShape> shapes;
  std::vector<uint32_t> of;
};

Models make_models(const std::vector<ThingSpec>& specs, const std::vector<ThingPlace>& placements, Seed seed,
                   const RunContext& run) {
  std::map<ShapeKey, uint32_t> numbers;
  for (const ThingPlace& p : placements) numbers[shape_of(p, specs[p.spec], seed)] = 0;
  std::vector<ShapeKey> keys;
  for (auto& [key, number] : numbers) {
    number = static_cast<uint32_t>(keys.size());
    keys.push_back(key);
  }
  Models models;
  models.shapes.resize(keys.size());
  parallel_blocks(run, static_cast<int64_t>(keys.size()), 1, [&](int64_t i, int64_t) {
    const ShapeKey& key = keys[static_cast<size_t>(i)];
    const ThingSpec& spec = specs[key.spec];
    const double health = static_cast<double>(key.health) / (kHealths - 1);
    models.shapes[static_cast<size_t>(i)] =
        spec.params.shape == ThingForm::file
            ? geom::shape_of_mesh(*spec.mesh, spec.params, spec.name, health)
            : geom::make_thing_shape(spec.params, spec.name, seed.derive("shapes"), key.variant, health);
  });
  models.of.reserve(placements.size());
  for (const ThingPlace& p : placements) models.of.push_back(numbers.at(shape_of(p, specs[p.spec], seed)));
  return models;
}

}  // namespace

Things place_things(const HeightField& terrain, const std::vector<ThingSpec>& specs,
                    const std::vector<ThingPlace>& placements, const PlaceThingsOptions& options, Seed seed,
                    const RunContext& run) {
  check(specs, placements);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  Models models = make_models(specs, placements, seed, run.part(0.0, 0.6));
  std::vector<std::optional<Thing>> standing(placements.size());
  constexpr int64_t kGrain = 4096;
  parallel_blocks(run.part(0.6, 1.0), static_cast<int64_t>(placements.size()), kGrain, [&](int64_t begin, int64_t end) {
    for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
      const ThingPlace& p = placements[i];
      const auto ground = footing(terrain, p.place);
      if (!ground) continue;
      const ThingShape& shape = models.shapes[models.of[i]];
      standing[i] = thing_on(terrain, *ground, p, specs[p.spec].params, shape.foot_m, shape.height_m, seed);
      standing[i]->shape = models.of[i];
    }
  });
  Things made;
  made.crs = terrain.frame().crs;
  made.shapes = std::move(models.shapes);
  if (options.keep_ground) made.ground = terrain;
  for (const auto& thing : standing)
    if (thing) made.things.push_back(*thing);
  if (made.things.size() < placements.size())
    run.say(std::to_string(placements.size() - made.things.size()) + " of " + std::to_string(placements.size()) +
            " things left out: beyond the terrain, or its height is not known there");
  keep_budget(made, options.max_triangles, seed, run);
  return made;
}

}  // namespace seamount::ecosystem

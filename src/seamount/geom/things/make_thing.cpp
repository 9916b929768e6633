#include "seamount/geom/things/make_thing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/geom/things/cluster_mesh.h"
#include "seamount/geom/things/makers.h"

namespace seamount::geom {
namespace {

struct Row {
  ThingMesh (*make)(const ThingMaking&);
  UsualThing usual;
};

/// In the order of ThingForm.
constexpr std::array<Row, 16> kForms = {{
    {make_rock, {1.2, 0.72, 1.0, 0.14, 0.34}},
    {make_pebble, {0.12, 0.6, 1.0, 0.12, 0.3}},
    {make_arch, {18.0, 0.62, 0.0, 0.04, 0.5}},
    {make_branching_coral, {0.7, 0.72, 0.8, 0.03, 0.2}},
    {make_massive_coral, {0.9, 0.68, 1.0, 0.05, 0.45}},
    {make_table_coral, {0.5, 0.34, 0.6, 0.04, 0.14}},
    {make_foliose_coral, {0.6, 0.62, 0.8, 0.04, 0.3}},
    {make_sea_fan, {0.9, 0.9, 0.5, 0.02, 0.05}},
    {make_sponge, {0.8, 0.95, 0.7, 0.04, 0.3}},
    {make_palm, {18.0, 1.75, 0.0, 0.005, 0.03}},
    {make_broadleaf, {13.0, 1.25, 0.0, 0.005, 0.04}},
    {make_conifer, {13.0, 3.0, 0.0, 0.005, 0.08}},
    {make_shrub, {1.6, 0.8, 0.3, 0.04, 0.15}},
    {make_mangrove, {6.0, 0.95, 0.0, 0.02, 0.3}},
    {make_seagrass, {0.45, 0.9, 0.4, 0.02, 0.35}},
    {make_kelp, {8.0, 2.2, 0.0, 0.005, 0.05}},
}};

/// How pale a mesh is at a health, and its box.
void measure(ThingShape& shape, double foot) {
  double height = 0.0, radius = 0.0;
  const std::vector<float>& p = shape.levels.front().positions;
  for (size_t i = 0; i < p.size(); i += 3) {
    height = std::max<double>(height, p[i + 2]);
    radius = std::max(radius, std::hypot(static_cast<double>(p[i]), static_cast<double>(p[i + 1])));
  }
  shape.height_m = static_cast<float>(height);
  shape.radius_m = static_cast<float>(radius);
  shape.foot_m = static_cast<float>(foot);
}

std::string ailing_name(std::string name, double health) {
  if (health < 1.0) name += "_h" + std::to_string(static_cast<int>(std::lround(100.0 * health)));
  return name;
}

}  // namespace

UsualThing usual(ThingForm form) {
  if (form == ThingForm::file) return {1.0, 1.0, 0.0, 0.02, 0.2};
  return kForms[static_cast<size_t>(form)].usual;
}

ThingSize size_of(const ThingParams& params) {
  const UsualThing as_usual = usual(params.shape);
  const double height = params.height_m  ? *params.height_m
                        : params.width_m ? *params.width_m * as_usual.slimness
                                         : as_usual.height_m;
  return {height, params.width_m ? *params.width_m : height / as_usual.slimness};
}

ThingMesh make_thing_mesh(const ThingParams& params, Seed seed, int variant, double health, int level) {
  const ThingSize size = size_of(params);
  ThingMaking making;
  making.seed = seed.derive("variant", static_cast<uint64_t>(variant));
  making.height_m = size.height_m;
  making.width_m = size.width_m;
  making.health = std::clamp(health, 0.0, 1.0);
  making.level = std::clamp(level, 0, 2);
  making.own_colour = params.colour == Colour{};
  making.colour = tone(params.colour);
  return kForms[static_cast<size_t>(params.shape)].make(making);
}

ThingShape make_thing_shape(const ThingParams& params, const std::string& name, Seed seed, int variant, double health) {
  ThingShape shape;
  shape.name = ailing_name(name + "_" + std::to_string(variant + 1), health);
  for (int level = 0; level < 3; ++level) shape.levels.push_back(make_thing_mesh(params, seed, variant, health, level));
  measure(shape, usual(params.shape).foot * size_of(params).width_m);
  return shape;
}

ThingShape shape_of_mesh(const ThingMesh& mesh, const ThingParams& params, const std::string& name, double health) {
  if (mesh.indices.empty()) throw InvalidArgument("mesh", "has no triangles");
  double low = 1e30, high = -1e30, wide = 0.0;
  for (size_t i = 0; i < mesh.positions.size(); i += 3) {
    low = std::min<double>(low, mesh.positions[i + 2]);
    high = std::max<double>(high, mesh.positions[i + 2]);
    wide = std::max<double>({wide, std::abs(mesh.positions[i]), std::abs(mesh.positions[i + 1])});
  }
  if (!(high > low) || !(wide > 0.0)) throw InvalidArgument("mesh", "is flat: it has no height or no width");
  const double up = params.height_m ? *params.height_m / (high - low) : 0.0,
               out = params.width_m ? 0.5 * *params.width_m / wide : 0.0;
  const double scale_z = up > 0.0 ? up : out > 0.0 ? out : 1.0, scale_xy = out > 0.0 ? out : scale_z;
  ThingShape shape;
  shape.name = ailing_name(name, health);
  ThingMesh fitted = mesh;
  for (size_t i = 0; i < fitted.positions.size(); i += 3) {
    std::array<double, 3> n{};
    for (size_t k = 0; k < 3; ++k) {
      const double scale = k == 2 ? scale_z : scale_xy;
      fitted.positions[i + k] = static_cast<float>(scale * fitted.positions[i + k]);
      n[k] = fitted.normals[i + k] / scale;
    }
    const double l = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (size_t k = 0; k < 3; ++k) fitted.normals[i + k] = static_cast<float>(n[k] / l);
  }
  for (Colour& colour : fitted.colours) colour = srgb(mix(tone(0xD8D2C4), tone(colour), 0.35 + 0.65 * health));
  shape.levels.push_back(std::move(fitted));
  for (const size_t most : {size_t{300}, size_t{40}}) {
    if (shape.levels.back().triangle_count() > most)
      shape.levels.push_back(cluster_mesh(shape.levels.front(), most));
    else
      shape.levels.push_back(shape.levels.back());
  }
  measure(shape, usual(ThingForm::file).foot * 2.0 * wide * scale_xy);
  return shape;
}

}  // namespace seamount::geom

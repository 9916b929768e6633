// glTF 2.0 binary with EXT_mesh_gpu_instancing.
#include <algorithm>
#include <cmath>
#include <map>

#include "seamount/io/glb_builder.h"
#include "seamount/io/things_file.h"

namespace seamount::io {
namespace {

uint16_t linear16(unsigned char encoded) {
  const double e = encoded / 255.0;
  const double l = e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
  return static_cast<uint16_t>(std::lround(65535.0 * l));
}

/// Materials of things, made when first used.
struct ThingMaterials {
  int solid = -1, leaves = -1;

  int of(GlbBuilder& glb, bool leaf) {
    int& number = leaf ? leaves : solid;
    if (number < 0) {
      OrderedJson material{{"name", leaf ? "leaves" : "solid"},
                           {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.95}}}};
      if (leaf) material["doubleSided"] = true;
      number = glb.add_material(std::move(material));
    }
    return number;
  }
};

int add_shape(GlbBuilder& glb, const ThingMesh& mesh, const std::string& name, ThingMaterials& materials) {
  std::vector<uint16_t> colours;
  for (const Colour& c : mesh.colours)
    colours.insert(colours.end(), {linear16(c.r), linear16(c.g), linear16(c.b), uint16_t{65535}});
  const OrderedJson attributes{{"POSITION", glb.places(y_up(mesh.positions), GlbBuilder::kVertices)},
                               {"NORMAL", glb.floats(y_up(mesh.normals), 3, GlbBuilder::kVertices)},
                               {"COLOR_0", glb.colours(std::move(colours))}};
  OrderedJson primitives = OrderedJson::array();
  const auto middle = mesh.indices.begin() + static_cast<ptrdiff_t>(mesh.solid);
  const auto add = [&](std::vector<uint32_t> indices, bool leaf) {
    if (indices.empty()) return;
    const int number = glb.indices(std::move(indices));
    primitives.push_back({{"attributes", attributes}, {"indices", number}, {"material", materials.of(glb, leaf)}});
  };
  add({mesh.indices.begin(), middle}, false);
  add({middle, mesh.indices.end()}, true);
  return glb.add_mesh({{"name", name}, {"primitives", std::move(primitives)}});
}

/// glTF's axes: x east, y up, z south.
struct GltfPose {
  std::array<double, 3> place;
  std::array<float, 4> rotation;
};
GltfPose gltf_pose(const Thing& thing, Vec2 origin) {
  const auto& q = thing.rotation;
  return {{thing.place.x - origin.x, thing.z_m, 0.0 - (thing.place.y - origin.y)}, {q[0], q[2], 0.0F - q[1], q[3]}};
}

void add_instances(GlbBuilder& glb, const std::vector<const Thing*>& things, Vec2 origin, int mesh,
                   const std::string& name) {
  std::vector<float> places, rotations, scales, tints, healths;
  for (const Thing* thing : things) {
    const GltfPose pose = gltf_pose(*thing, origin);
    for (const double p : pose.place) places.push_back(static_cast<float>(p));
    rotations.insert(rotations.end(), pose.rotation.begin(), pose.rotation.end());
    scales.insert(scales.end(), 3, thing->scale);
    tints.insert(tints.end(), 3, thing->tint);
    healths.push_back(thing->health);
  }
  constexpr int kUse = GlbBuilder::kInstances;
  OrderedJson attributes{{"TRANSLATION", glb.places(std::move(places), kUse)},
                         {"ROTATION", glb.floats(std::move(rotations), 4, kUse)},
                         {"SCALE", glb.places(std::move(scales), kUse)},
                         {"_COLOR_0", glb.floats(std::move(tints), 3, kUse)},
                         {"_HEALTH", glb.floats(std::move(healths), 1, kUse)}};
  glb.add_node({{"name", name},
                {"mesh", mesh},
                {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", std::move(attributes)}}}}}});
}

void add_nodes(GlbBuilder& glb, const std::vector<const Thing*>& things, Vec2 origin, int mesh,
               const std::string& name) {
  for (size_t i = 0; i < things.size(); ++i) {
    const GltfPose pose = gltf_pose(*things[i], origin);
    glb.add_node({{"name", name + "_" + std::to_string(i)},
                  {"mesh", mesh},
                  {"translation", pose.place},
                  {"rotation", pose.rotation},
                  {"scale", std::array{things[i]->scale, things[i]->scale, things[i]->scale}},
                  {"extras", {{"health", things[i]->health}}}});
  }
}

std::string level_name(const Things& things, uint32_t shape, uint32_t level) {
  return things.shapes[shape].name + "_lod" + std::to_string(level);
}

}  // namespace

Vec2 origin_of(const Things& things) {
  if (!things.ground.empty()) {
    const GridFrame& frame = things.ground.frame();
    return {frame.west_m + 0.5 * frame.width_m(), frame.north_m - 0.5 * frame.height_m()};
  }
  if (things.things.empty()) return {};
  Vec2 low = things.things[0].place, high = low;
  for (const Thing& thing : things.things) {
    low = {std::min(low.x, thing.place.x), std::min(low.y, thing.place.y)};
    high = {std::max(high.x, thing.place.x), std::max(high.y, thing.place.y)};
  }
  return {std::round(0.5 * (low.x + high.x)), std::round(0.5 * (low.y + high.y))};
}

void write_things_glb(const Things& things, const std::string& path, const ThingsFileOptions& options) {
  GlbBuilder glb;
  begin_glb(glb, options.provenance);
  const Vec2 origin = options.ground != nullptr ? options.ground->origin : origin_of(things);
  if (options.ground != nullptr)
    add_terrain(glb, *options.ground, {.texture = options.texture, .provenance = options.provenance});
  std::map<std::pair<uint32_t, uint32_t>, std::vector<const Thing*>> groups;
  for (const Thing& thing : things.things) groups[{thing.shape, thing.level}].push_back(&thing);
  if (options.instances && !groups.empty())
    glb.json["extensionsUsed"] = glb.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  ThingMaterials materials;
  for (const auto& [key, members] : groups) {
    const std::string name = level_name(things, key.first, key.second);
    const int mesh = add_shape(glb, things.shapes[key.first].levels[key.second], name, materials);
    options.instances ? add_instances(glb, members, origin, mesh, name) : add_nodes(glb, members, origin, mesh, name);
  }
  OrderedJson extras{{"units", "metres, sea level at y = 0"},
                     {"origin_x_m", origin.x},
                     {"origin_y_m", origin.y},
                     {"things", things.things.size()},
                     {"shapes", things.shapes.size()}};
  if (!things.crs.empty()) extras["crs"] = things.crs;
  if (!options.provenance.recipe.empty()) extras["recipe"] = options.provenance.recipe;
  if (options.provenance.seed) extras["seed"] = *options.provenance.seed;
  glb.json["scenes"][0]["extras"] = std::move(extras);
  if (glb.json["scenes"][0]["nodes"].empty()) glb.json["scenes"][0].erase("nodes");
  glb.write(path, "the things are too large for a GLB file (4 GiB); set max_triangles");
}

void write_shape_glb(const ThingMesh& mesh, const std::string& name, const std::string& path) {
  GlbBuilder glb;
  begin_glb(glb, {});
  ThingMaterials materials;
  const int number = add_shape(glb, mesh, name, materials);
  glb.add_node({{"name", name}, {"mesh", number}});
  glb.write(path, "the shape is too large for a GLB file (4 GiB)");
}

}  // namespace seamount::io

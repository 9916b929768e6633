// Tables of placements for engines.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/things_file.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct EngineText {
  std::string_view axes, unit, how;
};
constexpr std::array<EngineText, 4> kEngines = {{
    {"left-handed, z up: x east, y south", "cm",
     "Import the folder of shapes (Interchange glTF), then for each row spawn its mesh in an Instanced Static Mesh "
     "with "
     "Location (x, y, z), Rotation (pitch, yaw, roll) and Scale (scale, scale, scale); in Python: "
     "unreal.Transform(unreal.Vector(x, y, z), unreal.Rotator(roll, pitch, yaw), unreal.Vector(scale, scale, scale))"},
    {"left-handed, y up: x east, z north", "m",
     "Import the folder of shapes (glTFast or UnityGLTF), then for each row "
     "Instantiate(mesh, new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw)) with localScale = Vector3.one * scale"},
    {"right-handed, y up: x east, z south", "m",
     "Import the folder of shapes, then for each row multimesh.set_instance_transform(i, "
     "Transform3D(Basis(Quaternion(qx, qy, qz, qw)).scaled(Vector3.ONE * scale), Vector3(x, y, z)))"},
    {"right-handed, z up: x east, y north", "m",
     "Import the shapes (bpy.ops.import_scene.gltf), then for each row copy the object and set location = (x, y, z), "
     "rotation_mode = 'QUATERNION', rotation_quaternion = (qw, qx, qy, qz), scale = (scale, scale, scale)"},
}};

std::string number(double value, int digits) { return fmt::format("{:.{}f}", value + 0.0, digits); }

std::string mesh_name(const std::string& path, const Thing& thing) {
  return fs::path(path).stem().string() + "_shapes/shape_" + std::to_string(thing.shape) + "_lod" +
         std::to_string(thing.level) + ".glb";
}

/// Names of the columns, and their values as text.
std::vector<std::string> columns(ThingEngine engine) {
  std::vector<std::string> names = {"name", "shape", "mesh", "level", "x", "y", "z", "qx", "qy", "qz", "qw"};
  if (engine == ThingEngine::unreal) names.insert(names.end(), {"pitch", "yaw", "roll"});
  names.insert(names.end(), {"scale", "health", "tint"});
  return names;
}

std::vector<std::string> row(const Things& things, size_t i, Vec2 origin, const std::string& path, ThingEngine engine) {
  const Thing& thing = things.things[i];
  const EnginePose pose = engine_pose(thing, origin, engine);
  std::vector<std::string> values = {"thing_" + std::to_string(i), things.shapes[thing.shape].name,
                                     mesh_name(path, thing), std::to_string(thing.level)};
  for (const double p : pose.place) values.push_back(number(p, engine == ThingEngine::unreal ? 2 : 4));
  for (const double q : pose.rotation) values.push_back(number(q, 7));
  if (engine == ThingEngine::unreal)
    for (const double angle : pose.rotator) values.push_back(number(angle, 4));
  values.push_back(number(thing.scale, 5));
  values.push_back(number(thing.health, 3));
  values.push_back(number(thing.tint, 3));
  return values;
}

std::string csv(const Things& things, Vec2 origin, const std::string& path, ThingEngine engine) {
  std::string text = fmt::format("{}\n", fmt::join(columns(engine), ","));
  for (size_t i = 0; i < things.things.size(); ++i)
    text += fmt::format("{}\n", fmt::join(row(things, i, origin, path, engine), ","));
  return text;
}

std::string json(const Things& things, Vec2 origin, const std::string& path, ThingEngine engine,
                 const Provenance& provenance) {
  const EngineText& about = kEngines[static_cast<size_t>(engine)];
  Json head{{"engine", Choices<ThingEngine>::names[static_cast<size_t>(engine)]},
            {"axes", about.axes},
            {"unit", about.unit},
            {"origin_x_m", origin.x},
            {"origin_y_m", origin.y}};
  if (!things.crs.empty()) head["crs"] = things.crs;
  head["how"] = about.how;
  head["made_by"] = provenance.program;
  if (!provenance.recipe.empty()) head["recipe"] = provenance.recipe;
  if (provenance.seed) head["seed"] = *provenance.seed;
  head["columns"] = columns(engine);
  std::string text = head.dump(2, ' ', false, Json::error_handler_t::replace);
  text.resize(text.size() - 2);  // the end of the object
  text += ",\n  \"things\": [";
  for (size_t i = 0; i < things.things.size(); ++i) {
    const auto values = row(things, i, origin, path, engine);
    text += i == 0 ? "\n    [" : ",\n    [";
    for (size_t k = 0; k < values.size(); ++k)
      text += (k == 0 ? "" : ", ") + (k < 3 ? "\"" + values[k] + "\"" : values[k]);
    text += "]";
  }
  return text + "\n  ]\n}\n";
}

using Quaternion = std::array<double, 4>;

/// Unreal's rotator of a quaternion (FQuat::Rotator), degrees.
std::array<double, 3> rotator(const Quaternion& q) {
  const auto [x, y, z, w] = q;
  constexpr double kDegrees = 180.0 / std::numbers::pi, kPole = 0.4999995;
  const double singular = z * x - w * y;
  const double yaw = std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)) * kDegrees;
  if (std::abs(singular) > kPole) {
    const double sign = singular < 0.0 ? -1.0 : 1.0;
    return {sign * 90.0, yaw, std::remainder(-sign * yaw - 2.0 * sign * std::atan2(x, w) * kDegrees, 360.0)};
  }
  return {std::asin(2.0 * singular) * kDegrees, yaw,
          std::atan2(-2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)) * kDegrees};
}

}  // namespace

EnginePose engine_pose(const Thing& thing, Vec2 origin, ThingEngine engine) {
  const double x = thing.place.x - origin.x, y = thing.place.y - origin.y, z = thing.z_m;
  const double qx = thing.rotation[0], qy = thing.rotation[1], qz = thing.rotation[2], qw = thing.rotation[3];
  EnginePose pose;
  switch (engine) {
    case ThingEngine::unreal:
      pose.place = {100.0 * x, -100.0 * y, 100.0 * z};
      pose.rotation = {-qx, qy, -qz, qw};  // seen in a mirror along y
      pose.rotator = rotator(pose.rotation);
      break;
    case ThingEngine::unity: {
      pose.place = {x, z, y};
      const Quaternion mirrored = {-qx, -qz, -qy, qw};  // y and z change places
      // Half a turn about y first: importers show x of a model to the west.
      pose.rotation = {-mirrored[2], mirrored[3], mirrored[0], -mirrored[1]};
      break;
    }
    case ThingEngine::godot:
      pose.place = {x, z, -y};
      pose.rotation = {qx, qz, -qy, qw};
      break;
    case ThingEngine::blender:
      pose.place = {x, y, z};
      pose.rotation = {qx, qy, qz, qw};
      break;
  }
  return pose;
}

void write_placements(const Things& things, const std::string& path, ThingEngine engine, const Provenance& provenance) {
  const Vec2 origin = origin_of(things);
  const fs::path folder = fs::path(path).parent_path() / (fs::path(path).stem().string() + "_shapes");
  for (size_t shape = 0; shape < things.shapes.size(); ++shape) {
    for (size_t level = 0; level < things.shapes[shape].levels.size(); ++level) {
      const std::string name = "shape_" + std::to_string(shape) + "_lod" + std::to_string(level) + ".glb";
      write_shape_glb(things.shapes[shape].levels[level], things.shapes[shape].name, (folder / name).string());
    }
  }
  write_text(path, extension_of(path) == ".json" ? json(things, origin, path, engine, provenance)
                                                 : csv(things, origin, path, engine));
}

}  // namespace seamount::io

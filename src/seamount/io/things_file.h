// Things as files: GLB with instances, tables of placements for engines with their shapes as files.
//
// All are relative to an origin, so that large coordinates stay exact: the middle of the ground that the things stand
// on, else the middle of their places in whole metres. z is the height above sea level.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/io/provenance.h"
#include "seamount/model/image.h"
#include "seamount/model/mesh.h"
#include "seamount/model/things.h"

namespace seamount::io {

/// Where x = y = 0 of the files lies, metres of Things::crs.
Vec2 origin_of(const Things& things);

struct ThingsFileOptions {
  bool instances = true;           ///< EXT_mesh_gpu_instancing; else a node for each thing, with shared meshes
  const Mesh* ground = nullptr;    ///< the terrain in the same file; its origin is the things'
  const Image* texture = nullptr;  ///< of the ground
  Provenance provenance;
};

/// glTF 2.0 binary, y up: a mesh for each shape and level that is in use, in which leaves are a double-sided primitive,
/// with colours at vertices. With `instances` (the extension is required) one node for each of them: TRANSLATION,
/// ROTATION, SCALE, _COLOR_0 (the tint, linear, as three.js reads it) and _HEALTH. Levels are separate nodes, not
/// MSFT_lod, which no engine reads for instances. Throws IoError.
void write_things_glb(const Things& things, const std::string& path, const ThingsFileOptions& options = {});

/// One level of a shape as a GLB of its own, its foot at the origin.
void write_shape_glb(const ThingMesh& mesh, const std::string& name, const std::string& path);

enum class ThingEngine { unreal, unity, godot, blender };

/// An engine's axes: places and rotations of a table hold for shapes as its glTF importer brings them in.
///   unreal   cm, left-handed, z up: x east, y south. Also pitch, yaw, roll in degrees.
///   unity    m, left-handed, y up: x east, z north; glTFast and UnityGLTF import models turned by half a turn, which
///   the
///            rotation takes back
///   godot    m, right-handed, y up: x east, z south, as glTF
///   blender  m, right-handed, z up: x east, y north
struct EnginePose {
  std::array<double, 3> place{};
  std::array<double, 4> rotation{};  ///< x, y, z, w
  std::array<double, 3> rotator{};   ///< unreal: pitch, yaw, roll, degrees
};
EnginePose engine_pose(const Thing& thing, Vec2 origin, ThingEngine engine);

/// "things.csv" or "things.json" (by extension) and, in "things_shapes" beside it, shape_0_lod0.glb ... of every shape
/// and level. Columns: name (unique), shape, mesh (file), level, x, y, z, qx, qy, qz, qw, for unreal also pitch, yaw,
/// roll, then scale, health, tint. JSON has the same as lists and says axes, unit, origin and what to do with it.
/// Throws IoError.
void write_placements(const Things& things, const std::string& path, ThingEngine engine,
                      const Provenance& provenance = {});

}  // namespace seamount::io

template <>
struct seamount::Choices<seamount::io::ThingEngine> {
  static constexpr std::array<std::string_view, 4> names = {"unreal", "unity", "godot", "blender"};
};

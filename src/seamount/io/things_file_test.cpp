#include "seamount/io/things_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gazebo.h"
#include "seamount/io/input_file.h"
#include "seamount/io/mesh_info.h"
#include "seamount/io/thing_file.h"
#include "seamount/io/things_info.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;
using Vector = std::array<double, 3>;

/// A tetrahedron with a leaf on top.
ThingMesh mesh() {
  ThingMesh made;
  made.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 0.5F, 0, 2};
  made.normals = {0, 0, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
  made.colours.assign(5, {120, 100, 80});
  made.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 2, 3, 4};
  made.solid = 12;
  return made;
}

Things things(int count) {
  Things all;
  all.crs = "EPSG:32627";
  all.shapes = {{"one", {mesh(), mesh()}, 2.0F, 1.0F, 1.0F}, {"two", {mesh()}, 2.0F, 1.0F, 1.0F}};
  Rng rng(Seed{7});
  for (int i = 0; i < count; ++i) {
    Thing thing;
    thing.place = {512345.25 + rng.uniform(-200, 200), 7412345.5 + rng.uniform(-200, 200)};
    thing.z_m = rng.uniform(-5, 40);
    std::array<double, 4> q{rng.normal(), rng.normal(), rng.normal(), rng.normal()};
    const double l = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (size_t k = 0; k < 4; ++k) thing.rotation[k] = static_cast<float>(q[k] / l);
    thing.scale = static_cast<float>(rng.uniform(0.5, 2.0));
    thing.shape = static_cast<uint32_t>(i % 2);
    thing.level = thing.shape == 0 ? static_cast<uint32_t>(i / 2 % 2) : 0;
    all.things.push_back(thing);
  }
  return all;
}

/// A vector turned by a quaternion of doubles.
Vector turned_by(const std::array<double, 4>& q, const Vector& v) {
  return turned(
      {static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]), static_cast<float>(q[3])}, v);
}

class ThingsFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  Json glb(const std::string& name) const {
    const auto bytes = read_file(folder_ + "/" + name);
    uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, 4);
    return Json::parse(bytes.begin() + 20, bytes.begin() + 20 + length);
  }
  const std::string folder_ = ::testing::TempDir() + "seamount_things_file";
};

/// Where each engine shows a point of a shape (x east, y north, z up) whose glTF it imported, in east, north, up
/// metres.
Vector seen(ThingEngine engine, const EnginePose& pose, double scale, const Vector& point) {
  const Vector gltf = {point[0], point[2], -point[1]};
  Vector local{};
  switch (engine) {
    case ThingEngine::unreal:
      local = {100 * gltf[0], 100 * gltf[2], 100 * gltf[1]};
      break;
    case ThingEngine::unity:
      local = {-gltf[0], gltf[1], gltf[2]};
      break;
    case ThingEngine::godot:
      local = gltf;
      break;
    case ThingEngine::blender:
      local = {gltf[0], -gltf[2], gltf[1]};
      break;
  }
  for (double& v : local) v *= scale;
  Vector p = turned_by(pose.rotation, local);
  for (size_t k = 0; k < 3; ++k) p[k] += pose.place[k];
  switch (engine) {
    case ThingEngine::unreal:
      return {p[0] / 100, -p[1] / 100, p[2] / 100};
    case ThingEngine::unity:
      return {p[0], p[2], p[1]};
    case ThingEngine::godot:
      return {p[0], -p[2], p[1]};
    default:
      return p;
  }
}

TEST_F(ThingsFile, EnginesShowEachPointWhereItIs) {
  const Things all = things(50);
  const Vec2 origin = origin_of(all);
  for (const Thing& thing : all.things) {
    for (const ThingEngine engine :
         {ThingEngine::unreal, ThingEngine::unity, ThingEngine::godot, ThingEngine::blender}) {
      const EnginePose pose = engine_pose(thing, origin, engine);
      for (const Vector& point : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0.3, -0.4, 2.0}}) {
        const Vector way = turned(thing.rotation, point);
        const Vector at = seen(engine, pose, thing.scale, point);
        EXPECT_NEAR(at[0], thing.place.x - origin.x + thing.scale * way[0], 1e-4);
        EXPECT_NEAR(at[1], thing.place.y - origin.y + thing.scale * way[1], 1e-4);
        EXPECT_NEAR(at[2], thing.z_m + thing.scale * way[2], 1e-4);
      }
    }
  }
}

/// FRotator::Quaternion of the engine.
std::array<double, 4> unreal_quaternion(const Vector& rotator) {
  constexpr double kHalf = std::numbers::pi / 360.0;
  const double sp = std::sin(rotator[0] * kHalf), cp = std::cos(rotator[0] * kHalf), sy = std::sin(rotator[1] * kHalf),
               cy = std::cos(rotator[1] * kHalf), sr = std::sin(rotator[2] * kHalf), cr = std::cos(rotator[2] * kHalf);
  return {cr * sp * sy - sr * cp * cy, -cr * sp * cy - sr * cp * sy, cr * cp * sy - sr * sp * cy,
          cr * cp * cy + sr * sp * sy};
}

TEST_F(ThingsFile, RotatorsAreTheirQuaternions) {
  Things all = things(200);
  all.things[0].rotation = {0, std::sqrt(0.5F), 0, std::sqrt(0.5F)};  // at the pole
  all.things[1].rotation = {0, -std::sqrt(0.5F), 0, std::sqrt(0.5F)};
  for (const Thing& thing : all.things) {
    const EnginePose pose = engine_pose(thing, {}, ThingEngine::unreal);
    const auto q = unreal_quaternion(pose.rotator);
    double same = 0;
    for (size_t k = 0; k < 4; ++k) same += q[k] * pose.rotation[k];
    EXPECT_NEAR(std::abs(same), 1.0, 2e-6);
  }
}

TEST_F(ThingsFile, GlbHasANodeForEachShapeAndLevel) {
  const Things all = things(101);
  write_things_glb(all, folder_ + "/a.glb");
  const Json json = glb("a.glb");
  EXPECT_EQ(json.at("nodes").size(), 3U);
  EXPECT_EQ(json.at("extensionsRequired"), Json::array({"EXT_mesh_gpu_instancing"}));
  size_t instances = 0;
  for (const Json& node : json.at("nodes")) {
    const Json& attributes = node.at("extensions").at("EXT_mesh_gpu_instancing").at("attributes");
    const size_t count = json.at("accessors").at(attributes.at("TRANSLATION").get<size_t>()).at("count");
    for (const auto& [name, accessor] : attributes.items())
      EXPECT_EQ(json.at("accessors").at(accessor.get<size_t>()).at("count"), count) << name;
    instances += count;
  }
  EXPECT_EQ(instances, 101U);
  EXPECT_EQ(json.at("materials").size(), 2U);
  EXPECT_THAT(*describe_mesh(folder_ + "/a.glb"), Contains(Pair("things", "101")));
  EXPECT_THAT(*describe_mesh(folder_ + "/a.glb"), Contains(Pair("triangles", "505")));
}

TEST_F(ThingsFile, PlainNodesComeBackWhereTheyAre) {
  const Things all = things(40);
  write_things_glb(all, folder_ + "/b.glb", {.instances = false});
  const ThingMesh back = read_thing(folder_ + "/b.glb");
  EXPECT_EQ(back.triangle_count(), 40U * 5U);
  EXPECT_EQ(back.solid, 40U * 12U);
  const Vec2 origin = origin_of(all);
  for (const Thing& thing : all.things) {  // each foot is a vertex
    const Vector foot = {thing.place.x - origin.x, thing.place.y - origin.y, thing.z_m};
    double nearest = 1e9;
    for (size_t i = 0; i < back.positions.size(); i += 3)
      nearest = std::min(nearest, std::hypot(back.positions[i] - foot[0], back.positions[i + 1] - foot[1],
                                             back.positions[i + 2] - foot[2]));
    EXPECT_LT(nearest, 1e-3);
  }
}

TEST_F(ThingsFile, NothingIsAFileToo) {
  write_things_glb({}, folder_ + "/none.glb");
  EXPECT_FALSE(glb("none.glb").contains("extensionsRequired"));
  write_placements({}, folder_ + "/none.json", ThingEngine::unity);
  EXPECT_TRUE(Json::parse(read_text(folder_ + "/none.json", 1 << 20)).at("things").empty());
}

TEST_F(ThingsFile, TablesAgreeAndNameTheirMeshes) {
  const Things all = things(30);
  for (const ThingEngine engine : {ThingEngine::unreal, ThingEngine::godot}) {
    write_placements(all, folder_ + "/t.json", engine);
    write_placements(all, folder_ + "/t.csv", engine);
    const Json json = Json::parse(read_text(folder_ + "/t.json", 1 << 20));
    const size_t columns = json.at("columns").size();
    EXPECT_EQ(columns, engine == ThingEngine::unreal ? 17U : 14U);
    ASSERT_EQ(json.at("things").size(), 30U);
    for (const Json& row : json.at("things")) {
      EXPECT_EQ(row.size(), columns);
      EXPECT_TRUE(fs::exists(folder_ + "/" + row.at(2).get<std::string>())) << row.at(2);
    }
    EXPECT_THAT(*describe_placements(folder_ + "/t.json"), Contains(Pair("things", "30")));
    EXPECT_THAT(*describe_placements(folder_ + "/t.csv"), Contains(Pair("things", "30")));
    const std::string text = read_text(folder_ + "/t.csv", 1 << 20);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 31);
    EXPECT_EQ(std::count(text.begin(), text.end(), ','), 31 * static_cast<long>(columns - 1));
  }
  write_text(folder_ + "/other.json", "{}");
  EXPECT_FALSE(describe_placements(folder_ + "/other.json"));
}

TEST_F(ThingsFile, WorldsHoldThemAsModels) {
  const Things all = things(20);
  Mesh ground;
  MeshPart part;
  part.positions = {-9, -9, 0, 9, -9, 0, 0, 9, 0};
  part.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  part.indices = {0, 1, 2};
  ground.parts = {part};
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line; };
  write_gazebo(ground, GridFrame{10, 10, 40.0, 512145, 7412545, "EPSG:32627"}, folder_ + "/w.sdf",
               {.things = &all, .max_collisions = 7}, run);
  const std::string text = read_text(folder_ + "/w.sdf", 1 << 20);
  const auto count = [&](const std::string& what) {
    size_t n = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("<model name="), 21U);
  EXPECT_EQ(count("<box>"), 7U);
  EXPECT_TRUE(fs::exists(folder_ + "/w/shape_0_lod1.obj"));
  EXPECT_THAT(said, HasSubstr("the 7 largest of 20 things"));
  EXPECT_EQ(read_thing(folder_ + "/w/shape_1_lod0.obj").triangle_count(), 6U) << "the leaf has two sides";
}

}  // namespace
}  // namespace seamount::io

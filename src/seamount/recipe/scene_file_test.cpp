// Scenes to files and back, also after others have edited them.
#include "seamount/recipe/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "seamount/io/object_file.h"
#include "seamount/io/projection.h"
#include "seamount/io/test_files.h"
#include "seamount/io/vector.h"
#include "seamount/recipe/file_info.h"
#include "seamount/recipe/scene_json.h"

namespace seamount::recipe {
namespace {

using io::TestFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::Pair;

ObjectClass class_of(const std::string& name, SkeletonKind skeleton) {
  ObjectClass of;
  of.name = name;
  of.skeleton = skeleton;
  of.fitness = "depth";
  return of;
}

/// Something of everything. `origin`: where it lies.
Scene full_scene(const std::string& crs, Vec2 origin) {
  Scene scene;
  scene.catalogue.name = "small";
  scene.catalogue.materials.emplace_back();
  scene.catalogue.materials[0].name = "sand";
  scene.catalogue.classes = {class_of("coral", SkeletonKind::point), class_of("reef", SkeletonKind::curve),
                             class_of("lagoon", SkeletonKind::region)};
  scene.catalogue.classes[1].things = {{}};
  scene.surroundings.water_level_m = 0.1;
  scene.timeline = {StormEvent{1, 3, origin, 2.0, 90.0, 50.0}, CurrentEvent{0, 5, {origin, origin + Vec2{9, 9}}}};
  scene.frame = {100, 80, 2.5, origin.x - 125, origin.y + 100, crs};
  scene.windows = {{{40, 40, 0.25, origin.x, origin.y + 10, crs}, 7}};
  scene.seed = 18446744073709551615ULL;
  scene.iteration = 12;
  scene.next_id = 9;
  scene.owed = {{0, 1, 3}, {2, 0, 1}};
  const auto add = [&](uint64_t id, int of_class, Polyline points, std::vector<float> hold = {}) {
    for (Vec2& p : points) p = origin + p;
    const SkeletonKind kind = scene.catalogue.classes[static_cast<size_t>(of_class)].skeleton;
    scene.objects.push_back(
        {id, of_class, {kind, std::move(points), std::move(hold)}, 0.1 * static_cast<double>(id), 1.0 / 3.0, 5});
  };
  add(1, 2, {{-50.1, -50}, {50, -50}, {50, 50.7}, {-50, 50}}, {0.0F, 1.0F, 0.3F, 0.0F});
  add(3, 0, {{1.0 / 3.0, 1e-7}});
  add(5, 1, {{-20, 0}, {0, 10}, {20, 0}}, {1.0F, 1.0F, 1.0F});
  add(8, 0, {{5, 5}}, {0.5F});
  scene.objects[3].window = 1;
  scene.objects[1].keep = true;
  return scene;
}

TEST(SceneFile, IsReadBackAsItWasWritten) {
  for (const bool placed : {false, true}) {
    const Scene scene = full_scene(placed ? "EPSG:32740" : "", placed ? Vec2{352000, 7652000} : Vec2{0, 0});
    for (const char* name : {"a.json", "a.gpkg", "a.geojson"}) {
      const TestFolder folder;
      write_scene(scene, folder(name));
      Scene read = read_scene(folder(name), {});
      if (placed && std::string(name) == "a.geojson") {  // 0.02 mm
        ASSERT_EQ(read.objects.size(), scene.objects.size());
        for (size_t i = 0; i < read.objects.size(); ++i) {
          for (size_t k = 0; k < read.objects[i].skeleton.points.size(); ++k) {
            Vec2& p = read.objects[i].skeleton.points[k];
            const Vec2 expected = scene.objects[i].skeleton.points[k];
            EXPECT_LT(std::hypot(p.x - expected.x, p.y - expected.y), 2e-5);
            p = expected;
          }
        }
      }
      EXPECT_EQ(scene_json(read), scene_json(scene)) << name << (placed ? " placed" : "");
      EXPECT_EQ(read, scene) << name << (placed ? " placed" : "");
      Scene twice = scene;
      write_scene(twice, folder(std::string("again_") + name));
      EXPECT_TRUE(is_scene_file(folder(name)));
    }
  }
}

TEST(SceneFile, OfFeaturesAloneHasTheirClasses) {
  const TestFolder folder;
  std::ofstream(folder("a.geojson"))
      << R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32740"}}, "features": [
    {"type": "Feature", "properties": {"class": "palm"}, "geometry": {"type": "MultiPoint", "coordinates": [[352000, 7652000], [352010, 7652000]]}},
    {"type": "Feature", "properties": {"class": "wall", "size": 2}, "geometry": {"type": "LineString", "coordinates": [[352000, 7652000], [352010, 7652000]]}}]})";
  const Scene scene = read_scene(folder("a.geojson"), {});
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_EQ(scene.catalogue.classes.at(0).name, "palm");
  EXPECT_EQ(scene.catalogue.classes.at(1).skeleton, SkeletonKind::curve);
  EXPECT_EQ(scene.objects[0].id, 1U);
  EXPECT_EQ(scene.objects[2].size, 2.0);
  EXPECT_FALSE(is_scene_file(folder("a.geojson")));
}

TEST(SceneFile, ComesBackFromAnotherSystem) {
  const TestFolder folder;
  const Scene scene = full_scene("EPSG:32740", {352000, 7652000});
  for (const char* system : {"EPSG:4326", "EPSG:32739"}) {
    io::ObjectFile file;
    file.head = scene_head_json(scene).dump();
    for (const SceneObject& object : scene.objects)
      file.objects.push_back(
          {scene.catalogue.classes[static_cast<size_t>(object.of_class)].name, object.id, object.skeleton});
    file.crs = "EPSG:32739";
    std::vector<std::string> said;
    RunContext run;
    run.note = [&](const std::string& line) { said.push_back(line); };
    for (io::ObjectFeature& object : file.objects)
      object.skeleton.points = io::from_lonlat(io::to_lonlat(object.skeleton.points, "EPSG:32740"), file.crs);
    const std::string name = std::string(system) == "EPSG:4326" ? "a.geojson" : "a.gpkg";
    io::write_objects(file, folder(name));
    const Scene read = read_scene(folder(name), run);
    ASSERT_EQ(read.objects.size(), scene.objects.size());
    for (size_t i = 0; i < read.objects.size(); ++i) {
      const Vec2 off = read.objects[i].skeleton.points[0] - scene.objects[i].skeleton.points[0];
      EXPECT_LT(std::hypot(off.x, off.y), 1e-3);
    }
    EXPECT_THAT(said, Contains(HasSubstr("to WGS 84 / UTM zone 40S, the system of their scene")));
  }
}

TEST(SceneFile, IsDescribed) {
  const TestFolder folder;
  const Scene scene = full_scene("EPSG:32740", {352000, 7652000});
  for (const char* name : {"a.json", "a.gpkg", "a.geojson"}) {
    write_scene(scene, folder(name));
    const io::FileInfo info = describe_file(folder(name));
    EXPECT_THAT(info, Contains(Pair("format", "environmental objects"))) << name;
    EXPECT_THAT(info, Contains(Pair("classes", "coral 2, reef 1, lagoon 1")));
    EXPECT_THAT(info, Contains(Pair("iteration", "12")));
    EXPECT_THAT(info, Contains(Pair("coordinate system", "WGS 84 / UTM zone 40S")));
    EXPECT_THAT(info, Contains(Pair("window 1", HasSubstr("40 x 40 cells of 0.25 m"))));
  }
  const Drawing drawing = io::read_drawing(folder("a.geojson"), {}, {});
  EXPECT_EQ(drawing.points.size(), 2U) << "a drawing still";
  EXPECT_EQ(drawing.areas.size(), 1U);
  io::write_drawing(drawing, folder("d.geojson"));
  EXPECT_THAT(describe_file(folder("d.geojson")), Contains(Pair("format", "GeoJSON")));
}

TEST(SceneFile, OfAnotherKindIsRefusedWithItsPlace) {
  const TestFolder folder;
  const auto error_of = [&](const std::string& json) {
    std::ofstream(folder("a.json")) << json;
    try {
      read_scene(folder("a.json"), {});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(error_of("{}"), HasSubstr("these are no objects of a scene"));
  const std::string head =
      R"({"seamount_scene": 1, "catalogue": {"classes": [{"name": "a", "fitness": "1"}]}, "seed": 1, "next_id": 5, )";
  EXPECT_THAT(error_of(head + R"("iteration": -1})"), HasSubstr("/iteration: is below 0"));
  EXPECT_THAT(error_of(head + R"("iteration": 1, "windows": {"a": 2}})"), HasSubstr("/windows"));
  EXPECT_THAT(error_of(head + R"("iteration": 1, "owed": [{"class": "a", "window": 3, "count": 1}]})"),
              HasSubstr("there is no window 3"));
  EXPECT_THAT(error_of(head + R"("iteration": 1, "owed": [{"class": "a", "window": 0, "count": -1}]})"),
              HasSubstr("/owed/0/count: is below 0"));
  EXPECT_THAT(error_of(head + R"("iteration": 1, "objects": [{"id": 1, "class": "b", "points": [[0, 0]]}]})"),
              HasSubstr("'b' is no class"));
  EXPECT_THAT(error_of(head + R"("iteration": 1, "objects": [{"id": 7, "class": "a", "points": [[0, 0]]}]})"),
              HasSubstr("not below next_id"));
}

}  // namespace
}  // namespace seamount::recipe

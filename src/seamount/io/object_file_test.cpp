// Objects as a GIS finds them and gives them back.
#include "seamount/io/object_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <fstream>

#include "seamount/base/error.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using testing::HasSubstr;

ObjectFile small_file() {
  ObjectFile file;
  file.crs = "EPSG:32740";
  file.head = R"({"seamount_scene":1})";
  file.objects.push_back(
      {"lagoon",
       1,
       {SkeletonKind::region, {{352000, 7652000}, {352100, 7652000}, {352050, 7652100}}, {0.0F, 1.0F, 0.5F}}});
  file.objects.push_back({"coral", 3, {SkeletonKind::point, {{352000.5, 7652000.25}}}, 1.5, 0.75, 4, 2, 1, true});
  file.objects.push_back({"coral", 4, {SkeletonKind::point, {{352007, 7652000}}}});
  file.objects.push_back({"reef", 5, {SkeletonKind::curve, {{352000, 7652000}, {352010, 7652009}}}});
  return file;
}

TEST(ObjectFile, ComesBackAsAGisEditedIt) {
  const TestFolder folder;
  const std::string path = folder("a.gpkg");
  write_objects(small_file(), path);
  {
    const GdalCall call(path);
    const DatasetPtr dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    ASSERT_TRUE(dataset);
    OGRLayer& points = *dataset->GetLayerByName("points");
    OGRPoint moved(352001, 7652002), at(352010, 7652020);
    const OGRFeatureUniquePtr first{points.GetNextFeature()};
    first->SetGeometry(&moved);
    ASSERT_EQ(points.SetFeature(first.get()), OGRERR_NONE);
    OGRFeature added(points.GetLayerDefn());
    added.SetField("class", "coral");
    added.SetGeometry(&at);
    ASSERT_EQ(points.CreateFeature(&added), OGRERR_NONE);
    OGRLayer& curves = *dataset->GetLayerByName("curves");
    const OGRFeatureUniquePtr curve{curves.GetNextFeature()};
    ASSERT_EQ(curves.DeleteFeature(curve->GetFID()), OGRERR_NONE);
  }
  const ObjectFile read = read_objects(path);
  EXPECT_EQ(read.head, small_file().head);
  EXPECT_EQ(read.crs, "EPSG:32740");
  ASSERT_EQ(read.objects.size(), 4U);
  EXPECT_EQ(read.objects[0].skeleton, small_file().objects[0].skeleton);
  EXPECT_EQ(read.objects[1].id, 3U);
  EXPECT_EQ(read.objects[1].skeleton.points[0], (Vec2{352001, 7652002}));
  EXPECT_EQ(read.objects[1].size, 1.5);
  EXPECT_TRUE(read.objects[1].keep);
  EXPECT_EQ(read.objects[2].id, 4U);
  EXPECT_EQ(read.objects[3].id, 0U) << "it has none yet";
  EXPECT_EQ(read.objects[3].size, 1.0);
  EXPECT_EQ(read.objects[3].skeleton.points[0], (Vec2{352010, 7652020}));
}

TEST(ObjectFile, GivesTheSameBytesForTheSameObjects) {
  const TestFolder folder;
  for (const char* name : {"a.gpkg", "a.geojson"}) {
    write_objects(small_file(), folder(name));
    write_objects(small_file(), folder(std::string("again_") + name));
    const auto bytes = [&](const std::string& file) {
      std::ifstream stream(folder(file), std::ios::binary);
      return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    EXPECT_EQ(bytes(name), bytes(std::string("again_") + name));
  }
}

TEST(ObjectFile, RefusesWhatIsNoObject) {
  const TestFolder folder;
  const auto error_of =
      [&](const std::string& properties, const std::string& geometry) {
        std::ofstream(folder("a.geojson"))
            << R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )" << properties
            << R"(, "geometry": )" << geometry << "}]}";
        try {
          read_objects(folder("a.geojson"));
        } catch (const IoError& error) {
          return std::string(error.what());
        }
        return std::string();
      };
  const std::string point = R"({"type": "Point", "coordinates": [55, -21]})";
  EXPECT_EQ(error_of(R"({"class": "a"})", point), "");
  EXPECT_THAT(error_of(R"({"name": "a"})", point), HasSubstr("has no field \"class\""));
  EXPECT_THAT(error_of(R"({"class": "a", "hold": "2"})", point),
              HasSubstr("\"hold\" is no list of numbers from 0 to 1"));
  EXPECT_THAT(
      error_of(
          R"({"class": "a"})",
          R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]], [[5, 2], [6, 2], [6, 3], [5, 2]]]})"),
      HasSubstr("has a hole"));
  EXPECT_THAT(error_of(R"({"class": "a"})", R"({"type": "Point", "coordinates": [1e400, 0]})"),
              HasSubstr("not finite"));
  EXPECT_THROW(read_objects(folder("missing.gpkg")), IoError);
  EXPECT_THROW(read_objects(folder("a.shp")), IoError);
}

TEST(ObjectFile, KnowsAHead) {
  const TestFolder folder;
  ObjectFile file = small_file();
  for (const char* name : {"a.gpkg", "a.geojson"}) {
    write_objects(file, folder(name));
    EXPECT_TRUE(has_scene(folder(name)));
  }
  file.head.clear();
  for (const char* name : {"a.gpkg", "a.geojson"}) {
    write_objects(file, folder(name));
    EXPECT_FALSE(has_scene(folder(name)));
  }
  std::ofstream(folder("b.gpkg")) << "no database";
  std::ofstream(folder("b.geojson")) << "{";
  EXPECT_FALSE(has_scene(folder("b.gpkg")));
  EXPECT_FALSE(has_scene(folder("b.geojson")));
  EXPECT_THROW(has_scene(folder("missing.gpkg")), IoError);
}

}  // namespace
}  // namespace seamount::io

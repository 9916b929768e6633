// Files as GIS people have them: several layers, heights under any name, systems that are stretched, undefined or not
// stated.
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "seamount/io/gdal_call.h"
#include "seamount/io/info.h"
#include "seamount/io/projection.h"
#include "seamount/io/test_files.h"
#include "seamount/io/vector.h"
#include "seamount/io/vector_heights.h"

namespace seamount::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What a reading said.
struct Notes {
  std::vector<std::string> lines;
  RunContext run;
  Notes() {
    run.note = [this](const std::string& line) { lines.push_back(line); };
  }
};

struct TestLayer {
  std::string name;
  OGRwkbGeometryType type = wkbUnknown;
  std::vector<std::string> wkt;
  std::string field;                ///< empty: none
  std::vector<std::string> values;  ///< as text; empty text: null
  bool text = false;
};

void write_layers(const std::string& path, const char* driver, const std::string& crs,
                  const std::vector<TestLayer>& layers) {
  const GdalCall call(path);
  const auto system = parse_crs(crs);
  GDALDriver* const made_by = GetGDALDriverManager()->GetDriverByName(driver);
  const DatasetPtr dataset(made_by->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  for (const TestLayer& layer : layers) {
    OGRLayer* made = dataset->CreateLayer(layer.name.c_str(), system.get(), layer.type, nullptr);
    OGRFieldDefn id("ID", OFTInteger);
    made->CreateField(&id);
    if (!layer.field.empty()) {
      OGRFieldDefn field(layer.field.c_str(), layer.text ? OFTString : OFTReal);
      made->CreateField(&field);
    }
    for (size_t i = 0; i < layer.wkt.size(); ++i) {
      OGRFeature feature(made->GetLayerDefn());
      feature.SetField(0, static_cast<int>(i));
      if (!layer.field.empty() && !layer.values.at(i).empty()) feature.SetField(1, layer.values[i].c_str());
      OGRGeometry* geometry = nullptr;
      OGRGeometryFactory::createFromWkt(layer.wkt[i].c_str(), nullptr, &geometry);
      feature.SetGeometryDirectly(geometry);
      EXPECT_EQ(made->CreateFeature(&feature), OGRERR_NONE);
    }
  }
}

TEST(HeightNames, AreKnownInAnyCaseAndWithTheirUnit) {
  for (const char* name : {"height_m", "elevation",   "ELEV",           "ele",        "Contour",  "CONTOUR",
                           "level",    "Z",           "Hoehe",          "HÖHE",       "altitude", "alt",
                           "cota",     "Quota",       "KOTE",           "z_value",    "elev_m",   "ContourElevation",
                           "elev (m)", "height_amsl", "elevation_masl", "Elev_Metres"}) {
    const auto told = parse_height_name(name);
    ASSERT_TRUE(told) << name;
    EXPECT_EQ(told->unit_m, 1.0) << name;
  }
  for (const char* name : {"elev_ft", "ELEVATION_FEET", "contour_ft", "elevft", "Height [ft]", "z_feet"}) {
    const auto told = parse_height_name(name);
    ASSERT_TRUE(told) << name;
    EXPECT_NEAR(told->unit_m, 0.3048, 1e-9) << name;
  }
  EXPECT_NEAR(parse_height_name("elev_us_ft")->unit_m, 1200.0 / 3937.0, 1e-12);
  for (const char* name : {"id", "name", "population", "length", "m", "ft", "", "velocity", "elevator"})
    EXPECT_FALSE(parse_height_name(name)) << name;
}

TEST(HeightNames, TextsHoldNumbers) {
  EXPECT_EQ(parse_height("120", 1.0), 120.0);
  EXPECT_EQ(parse_height(" +120.50 m", 0.3048), 120.5);
  EXPECT_EQ(parse_height("-12,5", 2.0), -25.0);
  EXPECT_NEAR(*parse_height("394 ft", 1.0), 120.09, 0.01);
  for (const char* text : {"", "m", "hill", "1,250", "12 13", "nan", "inf", "12 apples", "1e400"})
    EXPECT_FALSE(parse_height(text, 1.0)) << text;
}

TEST(ReadContourLines, TakesTheFieldThatHoldsHeightsAndSaysWhich) {
  const TestFolder folder;
  for (const char* field : {"CONTOUR", "elev", "hoehe", "Z_VALUE"}) {
    const std::string path = folder(std::string(field) + ".gpkg");
    write_layers(path, "GPKG", "EPSG:32633",
                 {{"SELECT",
                   wkbLineString,
                   {"LINESTRING(0 0,9 0,9 9,0 0)", "LINESTRING(1 1,2 1,2 2,1 1)"},
                   field,
                   {"25", "50.5"}}});
    Notes notes;
    const Drawing drawing = read_contour_lines(path, {}, notes.run).drawing;
    EXPECT_EQ(drawing.lines.at(0).value, 25.0);
    EXPECT_EQ(drawing.lines.at(1).value, 50.5);
    EXPECT_TRUE(drawing.heights);
    EXPECT_EQ(drawing.crs, "EPSG:32633");
    EXPECT_THAT(notes.lines, Contains(HasSubstr("the field '" + std::string(field) + "'")));
  }
}

TEST(ReadContourLines, RespectsFeetAndTextAndNamedFields) {
  const TestFolder folder;
  const std::vector<std::string> lines = {"LINESTRING(0 0,9 0,9 9,0 0)", "LINESTRING(1 1,2 1,2 2,1 1)"};
  write_layers(folder("ft.gpkg"), "GPKG", "EPSG:32633", {{"c", wkbLineString, lines, "elev_ft", {"100", "200"}}});
  Notes notes;
  EXPECT_NEAR(read_contour_lines(folder("ft.gpkg"), {}, notes.run).drawing.lines.at(1).value, 60.96, 1e-9);
  EXPECT_THAT(notes.lines, Contains(HasSubstr("in feet")));
  write_layers(folder("text.gpkg"), "GPKG", "EPSG:32633",
               {{"c", wkbLineString, lines, "Elevation", {"100 m", "200,5"}, true}});
  EXPECT_EQ(read_contour_lines(folder("text.gpkg")).drawing.lines.at(1).value, 200.5);
  write_layers(folder("odd.gpkg"), "GPKG", "EPSG:32633", {{"c", wkbLineString, lines, "strange", {"7", "8"}}});
  EXPECT_EQ(read_contour_lines(folder("odd.gpkg"), {.height_field = "STRANGE"}).drawing.lines.at(1).value, 8.0);
  EXPECT_THAT(error_of([&] { read_contour_lines(folder("odd.gpkg")); }),
              HasSubstr("line 1 at (0, 0) has no height: no field is named like one; 'height_field' says which it is "
                        "(fields: ID, strange)"));
  EXPECT_THAT(error_of([&] { read_contour_lines(folder("odd.gpkg"), {.height_field = "strang"}); }),
              HasSubstr("no field 'strang', did you mean 'strange'?"));
}

TEST(ReadContourLines, ALineWithoutHeightIsAnError) {
  const TestFolder folder;
  const std::vector<std::string> lines = {"LINESTRING(0 0,9 0,9 9,0 0)", "LINESTRING(1 1,2 1,2 2,1 1)"};
  write_layers(folder("gap.gpkg"), "GPKG", "EPSG:32633", {{"c", wkbLineString, lines, "elev", {"100", ""}}});
  EXPECT_THAT(error_of([&] { read_contour_lines(folder("gap.gpkg")); }),
              HasSubstr("line 2 at (1, 1) has no height in its field 'elev' (fields: ID, elev)"));
  EXPECT_EQ(read_drawing(folder("gap.gpkg")).lines.at(1).value, 0.0) << "who needs no heights may read it";
}

TEST(ReadContourLines, TakesZOfLevelLines) {
  const TestFolder folder;
  const auto write = [&](const std::vector<std::string>& lines) {
    std::filesystem::remove(folder("z.gpkg"));
    write_layers(folder("z.gpkg"), "GPKG", "EPSG:32633", {{"c", wkbLineString25D, lines, "", {}}});
    return error_of([&] { read_contour_lines(folder("z.gpkg")); });
  };
  EXPECT_EQ(write({"LINESTRING Z(0 0 5,9 0 5,9 9 5,0 0 5)", "LINESTRING Z(1 1 6,2 1 6,2 2 6,1 1 6)"}), "");
  EXPECT_EQ(read_contour_lines(folder("z.gpkg")).drawing.lines.at(1).value, 6.0);
  EXPECT_THAT(write({"LINESTRING Z(0 0 5,9 0 7,9 9 5,0 0 5)"}), HasSubstr("is no contour: its z runs from 5 to 7"));
  EXPECT_THAT(write({"LINESTRING Z(0 0 0,9 0 0,9 9 0,0 0 0)", "LINESTRING Z(1 1 0,2 1 0,2 2 0,1 1 0)"}),
              HasSubstr("every z is 0"));
}

const char* const kIsland = "POLYGON((0 0,1000 0,1000 1000,0 1000,0 0))";

TEST(ChooseLayers, PassesOverEmptyOnesAndPoints) {
  const TestFolder folder;
  write_layers(folder("a.gpkg"), "GPKG", "EPSG:32627",
               {{"towns", wkbMultiPoint, {"MULTIPOINT(1 1,2 2)"}, "", {}},
                {"nothing", wkbPolygon, {}, "", {}},
                {"roads", wkbLineString, {"LINESTRING(0 0,5 5)"}, "", {}},
                {"coast", wkbPolygon, {kIsland}, "", {}}});
  Notes notes;
  EXPECT_EQ(read_areas(folder("a.gpkg"), {}, notes.run).areas.size(), 1U);
  EXPECT_THAT(notes.lines,
              Contains(HasSubstr("of its layers 'coast' is read; 'layer' names another (towns, roads, nothing)")));
  EXPECT_EQ(read_drawing(folder("a.gpkg")).lines.size(), 1U) << "the first of areas or lines";
  EXPECT_EQ(read_drawing(folder("a.gpkg"), {.layer = "towns"}).points.size(), 2U);
  EXPECT_THAT(error_of([&] { read_areas(folder("a.gpkg"), {.layer = "cost"}); }), HasSubstr("did you mean 'coast'?"));
  write_layers(folder("b.gpkg"), "GPKG", "EPSG:32627", {{"towns", wkbPoint, {"POINT(1 1)"}, "", {}}});
  EXPECT_THAT(error_of([&] { read_areas(folder("b.gpkg")); }), HasSubstr("has no areas in it, only points"));
  EXPECT_EQ(read_drawing(folder("b.gpkg")).points.size(), 1U);
}

TEST(Place, StretchedSystemsBecomeTrueMetres) {
  const TestFolder folder;
  // 10 km of Web Mercator at 61.5 N are 4.78 km.
  const std::vector<Vec2> corners = from_lonlat({{8.0, 61.5}}, "EPSG:3857");
  const Vec2 o = corners[0];
  const auto square = [&](double side) {
    char text[400];
    std::snprintf(text, sizeof text, "POLYGON((%.3f %.3f,%.3f %.3f,%.3f %.3f,%.3f %.3f,%.3f %.3f))", o.x, o.y,
                  o.x + side, o.y, o.x + side, o.y + side, o.x, o.y + side, o.x, o.y);
    return std::string(text);
  };
  write_layers(folder("m.gpkg"), "GPKG", "EPSG:3857", {{"a", wkbPolygon, {square(10000)}, "", {}}});
  const Drawing drawing = read_drawing(folder("m.gpkg"));
  const Ring& ring = drawing.areas.at(0).parts.at(0).outer;
  EXPECT_THAT(drawing.crs, HasSubstr("Local transverse Mercator"));
  const Vec2 side = ring[1] - ring[0];
  EXPECT_NEAR(std::hypot(side.x, side.y), 10000 * std::cos(61.5 * M_PI / 180), 20.0);
  // UTM is right within a thousandth and stays; feet do not.
  write_layers(folder("u.gpkg"), "GPKG", "EPSG:32627", {{"a", wkbPolygon, {kIsland}, "", {}}});
  EXPECT_EQ(read_drawing(folder("u.gpkg")).crs, "EPSG:32627");
  write_layers(
      folder("f.gpkg"), "GPKG", "EPSG:2227",  // California zone 3, US feet
      {{"a", wkbPolygon, {"POLYGON((6000000 2000000,6010000 2000000,6010000 2010000,6000000 2000000))"}, "", {}}});
  const Ring feet = read_drawing(folder("f.gpkg")).areas.at(0).parts.at(0).outer;
  const Vec2 edge = feet[1] - feet[0];
  EXPECT_NEAR(std::hypot(edge.x, edge.y), 3048.0, 3.0);
}

TEST(Place, UndefinedSystemsAreLocalMetres) {
  const TestFolder folder;
  for (const char* crs : {"LOCAL_CS[\"Undefined Cartesian SRS\"]",
                          "ENGCRS[\"site\",EDATUM[\"\"],CS[Cartesian,2],AXIS[\"x\",east],"
                          "AXIS[\"y\",north],LENGTHUNIT[\"metre\",1]]"}) {
    std::filesystem::remove(folder("l.gpkg"));
    write_layers(folder("l.gpkg"), "GPKG", crs, {{"a", wkbPolygon, {"POLYGON((0 0,9 0,9 9,0 0))"}, "", {}}});
    Notes notes;
    const Drawing drawing = read_drawing(folder("l.gpkg"), {}, notes.run);
    EXPECT_EQ(drawing.crs, "") << crs;
    EXPECT_EQ(drawing.areas.at(0).parts.at(0).outer.at(1), (Vec2{9, 0})) << "no guess: it says that it is no map";
    EXPECT_THAT(notes.lines, IsEmpty());
  }
}

TEST(Place, AFileThatSaysNothingIsGuessedBySizeAndToldSo) {
  const TestFolder folder;
  const auto write = [&](const std::string& name, const std::string& wkt) {
    write_layers(folder(name), "ESRI Shapefile", "", {{name.substr(0, 1), wkbPolygon, {wkt}, "", {}}});
    return folder(name);
  };
  const std::string degrees = write("d.shp", "POLYGON((8 50,8.1 50,8.1 50.1,8 50.1,8 50))");
  Notes notes;
  const Drawing drawing = read_drawing(degrees, {}, notes.run);
  EXPECT_THAT(drawing.crs, HasSubstr("Local transverse Mercator at 50.05 N 8.05 E"));
  EXPECT_THAT(notes.lines, Contains(HasSubstr("taken as longitude and latitude")));
  EXPECT_EQ(read_drawing(degrees, {.crs = "local"}).areas.at(0).parts.at(0).outer.size(), 4U);
  EXPECT_EQ(read_drawing(degrees, {.crs = "local"}).crs, "");
  const std::string metres = write("m.shp", "POLYGON((0 0,900 0,900 900,0 900,0 0))");
  Notes said;
  EXPECT_EQ(read_drawing(metres, {}, said.run).crs, "");
  EXPECT_THAT(said.lines, Contains(HasSubstr("taken as metres")));
  EXPECT_EQ(read_drawing(metres, {.crs = "EPSG:32632"}).crs, "EPSG:32632");
  EXPECT_THAT(error_of([&] { read_drawing(metres, {.crs = "nowhere"}); }), HasSubstr("'nowhere' is not a coordinate"));
}

TEST(Place, GeoJsonThatCannotBeDegreesIsInMetres) {
  const std::string text =
      R"({"type":"Polygon","coordinates":[[[500000,5000000],[501000,5000000],[501000,5001000],[500000,5000000]]]})";
  Notes notes;
  const Drawing drawing =
      read_geojson({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "m.geojson", {}, notes.run);
  EXPECT_EQ(drawing.crs, "");
  EXPECT_EQ(drawing.areas.at(0).parts.at(0).outer.at(0), (Vec2{500000, 5000000}));
  EXPECT_THAT(notes.lines, Contains(HasSubstr("m.geojson: its numbers are no longitudes and latitudes")));
}

TEST(ReadAreas, CarriesHeightsAndSwitches) {
  const TestFolder folder;
  write_text(folder("x.geojson"),
             R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32632"}},
"features":[{"type":"Feature","properties":{"name":"a","ELEV":120,"basin":true,"note":"yes","peak_m":5},
"geometry":{"type":"Polygon","coordinates":[[[500000,0],[501000,0],[501000,900],[500000,0]]]}}]})");
  const Attributes expected = {{"height_m", 120}, {"basin", 1}, {"note", 1}, {"peak_m", 5}};
  EXPECT_EQ(read_areas(folder("x.geojson")).areas.at(0).attributes, expected);
}

TEST(SheetLines, HaveTheRectangleOfTheirOwnCoordinates) {
  const TestFolder folder;
  write_layers(folder("s.gpkg"), "GPKG", "EPSG:4326",
               {{"c", wkbLineString, {"LINESTRING(8 46,9 47)", "LINESTRING(8.5 46,9 46.5)"}, "elev", {"1", "2"}}});
  const SheetLines read = read_contour_lines(folder("s.gpkg"));
  std::vector<Vec2> degrees = to_lonlat(read.sheet, read.drawing.crs);
  ASSERT_GE(degrees.size(), 100U);
  for (const Vec2 p : degrees) {
    const bool on_side =
        std::min({std::abs(p.x - 8), std::abs(p.x - 9), std::abs(p.y - 46), std::abs(p.y - 47)}) < 1e-7;
    EXPECT_TRUE(on_side) << p.x << ' ' << p.y;
  }
}

TEST(DescribeVector, TellsLayersShapesAndFields) {
  const TestFolder folder;
  write_layers(folder("a.gpkg"), "GPKG", "EPSG:32627",
               {{"towns", wkbMultiPoint, {"MULTIPOINT(1 1,2 2)"}, "", {}},
                {"lines", wkbLineString, {"LINESTRING(0 0,5 5)"}, "ELEV", {"5"}}});
  const FileInfo two = *describe_vector(folder("a.gpkg"));
  EXPECT_THAT(
      two, Contains(std::pair<std::string, std::string>(
               "layer 'lines'",
               "1 line; WGS 84 / UTM zone 27N (EPSG:32627); x 0 to 5, y 0 to 5 m; fields: ID (integer), ELEV (real)")));
  write_drawing({{{"isle", {{{{0, 0}, {10, 0}, {10, 10}}, {}}}}}, {}, {}}, folder("b.geojson"));
  const FileInfo one = *describe_vector(folder("b.geojson"));
  EXPECT_THAT(one, Contains(std::pair<std::string, std::string>("shapes", "1 area")));
  EXPECT_THAT(one, Contains(std::pair<std::string, std::string>("coordinate system", "none (local metres)")));
  EXPECT_THAT(one, Contains(std::pair<std::string, std::string>("features", "isle")));
}

}  // namespace
}  // namespace seamount::io

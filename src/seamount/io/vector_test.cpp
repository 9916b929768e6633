#include "seamount/io/vector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/io/projection.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// An island with a lagoon, an islet, and two other islands; degrees.
constexpr const char* kIslands = R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":1,"Name":"Kauai"},"geometry":{"type":"MultiPolygon","coordinates":[
 [[[-159.8,21.9],[-159.3,21.9],[-159.3,22.2],[-159.8,22.2],[-159.8,21.9]],
  [[-159.6,22.0],[-159.6,22.1],[-159.5,22.1],[-159.5,22.0],[-159.6,22.0]]],
 [[[-159.2,22.0],[-159.1,22.0],[-159.15,22.1],[-159.2,22.0]]]]}},
{"type":"Feature","properties":{"id":2,"Name":"Reunion"},"geometry":{"type":"Polygon","coordinates":[
 [[55.2,-21.3],[55.8,-21.3],[55.5,-20.9],[55.2,-21.3]]]}},
{"type":"Feature","properties":{"id":3,"Name":"Taveuni"},"geometry":{"type":"MultiPolygon","coordinates":[
 [[[179.8,-17],[180,-17],[180,-16.7],[179.8,-16.7],[179.8,-17]]],
 [[[-180,-17],[-179.8,-17],[-179.8,-16.7],[-180,-16.7],[-180,-17]]]]}}]})";

TEST(ReadAreas, ProjectsTheChosenFeature) {
  const TestFolder folder;
  write_text(folder("islands.geojson"), kIslands);
  const Drawing kauai = read_areas(folder("islands.geojson"), {.feature = "kauai"});
  ASSERT_EQ(kauai.areas.size(), 1U);
  ASSERT_EQ(kauai.areas[0].parts.size(), 2U);
  EXPECT_EQ(kauai.areas[0].name, "Kauai");
  EXPECT_EQ(kauai.areas[0].parts[0].outer.size(), 4U) << "the first point is not repeated";
  EXPECT_EQ(kauai.areas[0].parts[0].holes.size(), 1U);
  const std::vector<Vec2> degrees = to_lonlat(kauai.areas[0].parts[0].outer, kauai.crs);
  const std::vector<Vec2> truth = {{-159.8, 21.9}, {-159.3, 21.9}, {-159.3, 22.2}, {-159.8, 22.2}};
  for (size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(degrees[i].x, truth[i].x, 1e-7);
    EXPECT_NEAR(degrees[i].y, truth[i].y, 1e-7);
  }
  // The southern edge of 0.5 degrees: a cos(latitude) / sqrt(1 - e^2 sin^2(latitude)) metres a radian.
  const double latitude = 21.9 * M_PI / 180, e2 = 0.00669438;
  const double radius = 6378137.0 * std::cos(latitude) / std::sqrt(1 - e2 * std::pow(std::sin(latitude), 2));
  const Vec2 edge = kauai.areas[0].parts[0].outer[1] - kauai.areas[0].parts[0].outer[0];
  EXPECT_NEAR(std::hypot(edge.x, edge.y), radius * 0.5 * M_PI / 180, 5.0);
}

TEST(ReadAreas, JoinsWhatTheMapsEdgeCuts) {
  const TestFolder folder;
  write_text(folder("islands.geojson"), kIslands);
  const Drawing taveuni = read_areas(folder("islands.geojson"), {.feature = "TAVEUNI"});
  ASSERT_EQ(taveuni.areas[0].parts.size(), 1U);
  double west = INFINITY, east = -INFINITY;
  for (const Vec2& p : taveuni.areas[0].parts[0].outer) west = std::min(west, p.x), east = std::max(east, p.x);
  EXPECT_NEAR(east - west, 42'600, 100);
  EXPECT_NEAR(east + west, 0, 1);
}

TEST(ReadAreas, SaysWhatIsWrong) {
  const TestFolder folder;
  const auto message = [&](const std::string& text, const VectorOptions& options = {}) {
    write_text(folder("x.geojson"), text);
    return error_of([&] { read_areas(folder("x.geojson"), options); });
  };
  EXPECT_THAT(message(kIslands), HasSubstr("choose one feature by its name"));
  EXPECT_THAT(message(kIslands, {.feature = "kawai"}), HasSubstr("no feature 'kawai', did you mean 'Kauai'?"));
  EXPECT_THAT(message(kIslands, {.layer = "nope"}), HasSubstr("no layer 'nope'"));
  EXPECT_THAT(message(""), HasSubstr("is not a"));
  EXPECT_THAT(message("{\"type\":\"FeatureCollection\",\"features\":[]}"), HasSubstr("no areas, lines or points"));
  EXPECT_THAT(message(R"({"type":"Point","coordinates":[1,2]})"), HasSubstr("no areas in it, only points"));
  EXPECT_THAT(message(R"({"type":"LineString","coordinates":[[1,2000],[3,4000]]})", {.crs = "EPSG:4326"}),
              HasSubstr("not longitude and"));
  EXPECT_THAT(error_of([&] { read_areas(folder("missing.gpkg")); }), HasSubstr("no such file"));
  write_text(folder("x.dxf"), "0");
  EXPECT_THAT(error_of([&] { read_areas(folder("x.dxf")); }), HasSubstr("not a vector format"));
}

TEST(ReadGeojson, EveryShorterTextIsHandled) {
  const std::string text = kIslands;
  for (size_t length = 0; length < text.size() - 2; ++length) {
    const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(text.data()), length);
    EXPECT_THROW(read_geojson(bytes, "short.geojson", {.feature = "kauai"}), IoError) << length;
  }
}

Drawing sample(const std::string& crs) {
  Drawing drawing;
  drawing.crs = crs;
  drawing.areas.push_back(
      {"isle \"A\" <&>", {{{{0, 0}, {1000, 0}, {1000, 500.25}, {0, 500}}, {{{100, 100}, {100, 200}, {200, 150}}}}}});
  drawing.areas.push_back(
      {"rock", {{{{2000, 0}, {2100, 0}, {2050, 80}}, {}}, {{{3000, 0}, {3100, 0}, {3050, 80}}, {}}}});
  drawing.areas[1].attributes = {{"depth_m", 3.5}};
  drawing.lines.push_back({{{0, 0}, {10.5, 20}, {30, 10}}, 12.5, false, {{"order", 2}, {"width_m", 4.25}}});
  drawing.lines.push_back({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, -5, true});
  drawing.points.push_back({{40, 50}, 1234.5, {{"prominence_m", 321}}});
  return drawing;
}

void expect_same(const Drawing& a, const Drawing& b, double tolerance) {
  ASSERT_EQ(a.areas.size(), b.areas.size());
  const auto near = [&](const std::vector<Vec2>& p, const std::vector<Vec2>& q) {
    ASSERT_EQ(p.size(), q.size());
    for (size_t i = 0; i < p.size(); ++i) {
      EXPECT_NEAR(p[i].x, q[i].x, tolerance);
      EXPECT_NEAR(p[i].y, q[i].y, tolerance);
    }
  };
  for (size_t i = 0; i < a.areas.size(); ++i) {
    EXPECT_EQ(a.areas[i].name, b.areas[i].name);
    EXPECT_EQ(a.areas[i].attributes, b.areas[i].attributes);
    ASSERT_EQ(a.areas[i].parts.size(), b.areas[i].parts.size());
    for (size_t k = 0; k < a.areas[i].parts.size(); ++k) {
      near(a.areas[i].parts[k].outer, b.areas[i].parts[k].outer);
      ASSERT_EQ(a.areas[i].parts[k].holes.size(), b.areas[i].parts[k].holes.size());
      for (size_t h = 0; h < a.areas[i].parts[k].holes.size(); ++h)
        near(a.areas[i].parts[k].holes[h], b.areas[i].parts[k].holes[h]);
    }
  }
  ASSERT_EQ(a.lines.size(), b.lines.size());
  for (size_t i = 0; i < a.lines.size(); ++i) {
    EXPECT_EQ(a.lines[i].value, b.lines[i].value);
    EXPECT_EQ(a.lines[i].closed, b.lines[i].closed);
    near(a.lines[i].points, b.lines[i].points);
    EXPECT_EQ(a.lines[i].attributes, b.lines[i].attributes);
  }
  ASSERT_EQ(a.points.size(), b.points.size());
  for (size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_EQ(a.points[i].value, b.points[i].value);
    EXPECT_EQ(a.points[i].attributes, b.points[i].attributes);
    near({a.points[i].place}, {b.points[i].place});
  }
}

/// Both in the same system, for comparing places.
Drawing in_system(Drawing drawing, const std::string& crs) {
  const auto move = [&](std::vector<Vec2>& points) { points = from_lonlat(to_lonlat(points, drawing.crs), crs); };
  for (NamedArea& area : drawing.areas) {
    for (Polygon& part : area.parts) {
      move(part.outer);
      for (Ring& hole : part.holes) move(hole);
    }
  }
  for (ValuedLine& line : drawing.lines) move(line.points);
  for (ValuedPoint& point : drawing.points) {
    std::vector<Vec2> place{point.place};
    move(place);
    point.place = place.front();
  }
  return drawing;
}

TEST(WriteDrawing, GeoJsonComesBack) {
  const TestFolder folder;
  write_drawing(sample(""), folder("local.geojson"));
  const Drawing local = read_drawing(folder("local.geojson"));
  EXPECT_EQ(local.crs, "");
  expect_same(local, sample(""), 1e-6);
  const std::string crs = local_crs(-159.5, 22.05);
  write_drawing(sample(crs), folder("placed.geojson"));
  expect_same(in_system(read_drawing(folder("placed.geojson")), crs), sample(crs), 1e-4);
}

TEST(WriteDrawing, GeoPackageComesBackAndIsTheSameEveryTime) {
  const TestFolder folder;
  for (const std::string& crs : {std::string("EPSG:32604"), std::string(), local_crs(12.5, -30)}) {
    write_drawing(sample(crs), folder("a.gpkg"));
    Drawing back = read_drawing(folder("a.gpkg"), {.layer = "areas"});
    back.lines = read_drawing(folder("a.gpkg"), {.layer = "lines"}).lines;
    back.points = read_drawing(folder("a.gpkg"), {.layer = "points"}).points;
    expect_same(back, sample(crs), 1e-9);
    EXPECT_EQ(crs_name(back.crs), crs_name(crs));
    if (!crs.empty()) expect_same(in_system(back, crs), sample(crs), 1e-6);
    write_drawing(sample(crs), folder("b.gpkg"));
    EXPECT_EQ(read_file(folder("a.gpkg")), read_file(folder("b.gpkg")));
  }
  EXPECT_EQ(folder.files(), 2U);
}

TEST(WriteDrawing, HeightsAreAnAttributeAndZ) {
  const TestFolder folder;
  Drawing drawing;
  drawing.heights = true;
  drawing.lines = {{{{0, 0}, {100, 0}, {100, 50}}, 120.5, true, {}}, {{{10, 10}, {60, 20}}, -3, false, {}}};
  for (const char* file : {"lines.geojson", "lines.gpkg"}) {
    write_drawing(drawing, folder(file));
    const Drawing back = read_drawing(folder(file));
    EXPECT_TRUE(back.heights) << file;
    EXPECT_EQ(back.lines, drawing.lines) << file;
  }
  const std::vector<uint8_t> bytes = read_file(folder("lines.geojson"));
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_THAT(text, HasSubstr("\"height_m\":120.5"));
  EXPECT_THAT(text, HasSubstr("[100,0,120.5]"));
}

TEST(WriteDrawing, TheFrameGoesAlong) {
  const TestFolder folder;
  for (const std::string& crs : {std::string(), std::string("EPSG:32604"), local_crs(12.5, -30)}) {
    Drawing drawing;
    drawing.crs = crs;
    drawing.heights = true;
    drawing.lines = {{{{0, 0}, {100, 0}, {100, 50}}, 120.5, true, {}}};
    drawing.frame = GridFrame{512, 300, 7.25, -1234.5, 4321.0625, crs};
    for (const char* file : {"lines.gpkg", "lines.geojson"}) {
      write_drawing(drawing, folder(file));
      const Drawing back = read_drawing(folder(file));
      ASSERT_TRUE(back.frame.has_value()) << file;
      EXPECT_EQ(back.frame->crs, back.crs) << file;
      GridFrame frame = *back.frame;
      frame.crs = crs;
      EXPECT_EQ(frame, *drawing.frame) << file;
      for (size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(back.lines[0].points[i].x, drawing.lines[0].points[i].x, 1e-4) << file << " in its own system";
        EXPECT_NEAR(back.lines[0].points[i].y, drawing.lines[0].points[i].y, 1e-4);
      }
    }
    write_drawing(drawing, folder("again.gpkg"));
    EXPECT_EQ(read_file(folder("again.gpkg")), read_file(folder("lines.gpkg")));
    write_drawing(drawing, folder("lines.svg"));
    const std::vector<uint8_t> bytes = read_file(folder("lines.svg"));
    const std::string svg(bytes.begin(), bytes.end());
    EXPECT_THAT(svg, HasSubstr("data-seamount-frame=\"512 300 7.25 -1234.5 4321.0625\""));
    EXPECT_THAT(svg, HasSubstr("viewBox=\"-1234.5 -4321.062 3712 2175\""));
  }
}

TEST(ReadGeojson, FramesOfOthersAndDamagedOnesAreTold) {
  const auto read = [](const std::string& member, const std::string& properties = "{}") {
    const std::string text = R"({"type":"FeatureCollection",)" + member +
                             R"("features":[{"type":"Feature","properties":)" + properties +
                             R"(,"geometry":{"type":"LineString","coordinates":[[50,5],[50.1,5]]}}]})";
    return read_geojson({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "x.geojson");
  };
  EXPECT_FALSE(read("").frame.has_value());
  EXPECT_FALSE(read("", R"({"seamount":5})").frame.has_value()) << "an attribute of that name";
  EXPECT_EQ(read(R"("seamount":{"frame":"8 9 10 -1 2.5","crs":"EPSG:32639"},)").frame->height, 9);
  for (const char* member :
       {R"("seamount":7,)", R"("seamount":{"frame":"8 9","crs":""},)", R"("seamount":{"frame":"8 0 1 1 1","crs":""},)",
        R"("seamount":{"frame":"8 9 10 1 nan","crs":""},)", R"("seamount":{"frame":"8 9 10 1 1"},)",
        R"("seamount":{"frame":"8 9 10 1 1","crs":"EPSG:4326"},)",
        R"("seamount":{"frame":"8 9 10 1 1","crs":"nonsense"},)"}) {
    EXPECT_THAT(error_of([&] { read(member); }), HasSubstr("x.geojson: ")) << member;
  }
}

TEST(ReadDrawing, LayersOfOurOwnAreReadTogetherThoseOfOthersOneByOne) {
  const TestFolder folder;
  write_drawing(sample(""), folder("all.gpkg"));
  expect_same(read_drawing(folder("all.gpkg")), sample(""), 1e-9);
  EXPECT_EQ(read_drawing(folder("all.gpkg"), {.layer = "lines"}).areas.size(), 0U);
  EXPECT_THAT(error_of([&] { read_drawing(folder("all.gpkg"), {.layer = "line"}); }),
              HasSubstr("did you mean 'lines'"));
}

TEST(ReadGeojson, TakesZWhereNoAttributeSaysAHeight) {
  const std::string text =
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32632"}},"features":[{"type":"Feature",
"properties":{},"geometry":{"type":"LineString","coordinates":[[500000,5000000,40],[500100,5000000,40]]}}]})";
  const Drawing drawing = read_geojson({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "z.geojson");
  EXPECT_EQ(drawing.lines.at(0).value, 40.0);
}

TEST(WriteDrawing, SvgHasNorthUp) {
  const TestFolder folder;
  write_drawing(sample(""), folder("x.svg"));
  const std::vector<uint8_t> bytes = read_file(folder("x.svg"));
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_THAT(text, HasSubstr("M0 0L1000 0L1000 -500.25L0 -500Z"));
  EXPECT_THAT(text, HasSubstr("data-name=\"isle &quot;A&quot; &lt;&amp;&gt;\""));
  EXPECT_THAT(text, HasSubstr("data-value=\"12.5\" data-order=\"2\" data-width-m=\"4.25\" d=\"M0 0L10.5 -20L30 -10\""));
}

TEST(WriteDrawing, FullDiskLeavesNothing) {
  const TestFolder folder;
  Drawing drawing = sample("EPSG:32604");
  for (int i = 0; i < 3000; ++i) drawing.lines[0].points.push_back({1.5 * i, std::sqrt(i)});
  for (const std::string extension : {".gpkg", ".geojson", ".svg"}) {
    const FileSizeLimit limit(16384);
    EXPECT_THAT(error_of([&] { write_drawing(drawing, folder("x" + extension)); }), HasSubstr("cannot be written"));
    EXPECT_EQ(folder.files(), 0U) << extension;
  }
}

TEST(ReadGeojson, NeverFetchesFromTheNetwork) {
  const std::string text =
      R"({"type":"LineString","crs":{"type":"link","properties":{"href":"http://127.0.0.1:9/crs","url":"http://127.0.0.1:9/crs","type":"ogcwkt"}},"coordinates":[[1,2],[3,4]]})";
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(text.data()), text.size());
  try {
    read_geojson(bytes, "link.geojson");
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), Not(HasSubstr("127.0.0.1:9 port")));
  }
}

TEST(Projection, KnowsItsErrors) {
  EXPECT_THROW(to_lonlat({{0, 0}}, "EPSG:nonsense"), InvalidArgument);
  EXPECT_THROW(to_lonlat({{0, 0}}, ""), InvalidArgument);
  EXPECT_EQ(crs_name("EPSG:32604"), "WGS 84 / UTM zone 4N");
  const Vec2 place = from_lonlat({{-159, 0}}, "EPSG:32604")[0];
  EXPECT_NEAR(place.x, 500000, 1e-6);
  EXPECT_NEAR(place.y, 0, 1e-6);
}

}  // namespace
}  // namespace seamount::io

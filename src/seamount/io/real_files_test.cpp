// Rasters as other programs and other people make them: places, units and codes that have to be understood.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/join.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/io/vertical_unit.h"

namespace seamount::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A GeoTIFF as its maker wants it.
struct Made {
  int width = 60, height = 50;
  std::array<double, 6> transform{5e5, 10, 0, 4e6, 0, -10};
  std::string crs = "EPSG:32633";
  std::string unit = {};
  GDALDataType type = GDT_Float32;
  int bands = 1;
  double scale = 1.0, offset = 0.0;
  std::function<double(int x, int y)> value = [](int, int) { return 100.0; };
};

std::string make_tiff(const std::string& path, const Made& made) {
  const GdalCall call(path);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const DatasetPtr dataset(driver->Create(path.c_str(), made.width, made.height, made.bands, made.type, nullptr));
  std::array<double, 6> transform = made.transform;
  dataset->SetGeoTransform(transform.data());
  if (const auto system = parse_crs(made.crs)) dataset->SetSpatialRef(system.get());
  for (int b = 1; b <= made.bands; ++b) {
    GDALRasterBand& band = *dataset->GetRasterBand(b);
    if (!made.unit.empty()) band.SetUnitType(made.unit.c_str());
    if (made.scale != 1.0) band.SetScale(made.scale);
    if (made.offset != 0.0) band.SetOffset(made.offset);
    for (int y = 0; y < made.height; ++y) {
      std::vector<double> row(static_cast<size_t>(made.width));
      for (int x = 0; x < made.width; ++x) row[static_cast<size_t>(x)] = made.value(x, y);
      const CPLErr written = band.RasterIO(GF_Write, 0, y, made.width, 1, row.data(), made.width, 1, GDT_Float64, 0, 0);
      EXPECT_EQ(written, CE_None);
    }
  }
  return path;
}

struct Read {
  HeightField heights;
  std::vector<std::string> notes;
};

Read read(const std::string& path, ReadOptions options = {}) {
  Read result;
  options.run.note = [&](const std::string& line) { result.notes.push_back(line); };
  result.heights = read_heights(path, options);
  return result;
}

/// Height = longitude and latitude, so that each place can be checked by its value.
double by_place(double longitude, double latitude) { return 10 * longitude + latitude; }

void expect_right_places(const HeightField& heights, double tolerance) {
  const GridFrame& frame = heights.frame();
  for (int y = 0; y < frame.height; y += 7) {
    for (int x = 0; x < frame.width; x += 7) {
      const Vec2 at = to_lonlat({{frame.x(x), frame.y(y)}}, frame.crs)[0];
      const double wanted = by_place(at.x < 0 ? at.x + 360 : at.x, at.y);
      ASSERT_NEAR(heights(x, y), wanted, tolerance) << x << " " << y << " at " << at.x << " " << at.y;
    }
  }
}

/// Around the 180th meridian, from either side, and in longitudes from 0 to 360.
TEST(RealFiles, LongitudesAreModular) {
  const TestFolder folder;
  for (const double west : {179.8, -180.2, 179.95, 180.3, 539.9}) {
    Made made{.transform = {west, 0.005, 0, -16.8, 0, -0.005}, .crs = "EPSG:4326"};
    made.value = [&](int x, int y) {
      const double longitude = west + (x + 0.5) * 0.005;
      return by_place(longitude - 360 * std::floor(longitude / 360), -16.8 - (y + 0.5) * 0.005);
    };
    expect_right_places(read(make_tiff(folder("d.tif"), made)).heights, 0.002);
  }
}

TEST(RealFiles, MetresThatAreNoneAreWarped) {
  const TestFolder folder;
  const auto mercator = parse_crs("EPSG:3857");
  const Vec2 corner = from_lonlat({{7.95, 61.65}}, "EPSG:3857")[0];
  Made made{.transform = {corner.x, 40, 0, corner.y, 0, -40}, .crs = "EPSG:3857"};
  made.value = [](int x, int) { return 10.0 * x; };  // rises by a quarter in the file's metres
  const Read north = read(make_tiff(folder("m.tif"), made));
  EXPECT_THAT(north.notes, ElementsAre(HasSubstr("off by up to 110")));
  const HeightField& z = north.heights;
  const int middle = z.height() / 2;
  const double slope = (z(z.width() - 5, middle) - z(5, middle)) / ((z.width() - 10) * z.cell_m());
  EXPECT_NEAR(slope, 0.25 / std::cos(61.63 * 3.14159265 / 180), 0.01);
  made.crs = "EPSG:32633";  // UTM is off by less than a thousandth
  made.transform = {5e5, 40, 0, 6.8e6, 0, -40};
  const Read utm = read(make_tiff(folder("u.tif"), made));
  EXPECT_THAT(utm.notes, IsEmpty());
  EXPECT_EQ(utm.heights.frame().crs, "EPSG:32633");
}

TEST(RealFiles, RowsAndColumnsRunEitherWay) {
  const TestFolder folder;
  const auto value = [](double x, double y) { return (x - 5e5) / 10 + (y - 4e6); };
  for (const bool south_up : {false, true}) {
    for (const bool east_first : {false, true}) {
      Made made;
      const double dx = east_first ? -10 : 10, dy = south_up ? 10 : -10;
      made.transform = {east_first ? 5e5 + 600 : 5e5, dx, 0, south_up ? 4e6 - 500 : 4e6, 0, dy};
      made.value = [&](int x, int y) {
        return value(made.transform[0] + (x + 0.5) * dx, made.transform[3] + (y + 0.5) * dy);
      };
      const HeightField heights = read(make_tiff(folder("f.tif"), made)).heights;
      const GridFrame& frame = heights.frame();
      EXPECT_EQ(frame.west_m, 5e5);
      EXPECT_EQ(frame.north_m, 4e6);
      for (const auto& [x, y] : {std::pair{0, 0}, {59, 0}, {0, 49}, {31, 17}})
        EXPECT_NEAR(heights(x, y), value(frame.x(x), frame.y(y)), 1e-3) << south_up << east_first;
    }
  }
}

TEST(RealFiles, CodesForNothingAreVoids) {
  const TestFolder folder;
  const float lowest = std::numeric_limits<float>::lowest();
  for (const double code : {-9999.0, -32768.0, 32767.0, -99999.0, static_cast<double>(lowest), 3.4e38, -3.4e38}) {
    Made made;
    made.value = [&](int x, int y) { return x >= 20 && x < 30 && y >= 20 && y < 30 ? code : 100.0 + x; };
    const Read got = read(make_tiff(folder("v.tif"), made));
    EXPECT_THAT(got.notes, ElementsAre(HasSubstr("100 cells of"), HasSubstr("100 of 3000 cells have no value")))
        << code;
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 60; ++x) ASSERT_EQ(std::isnan(got.heights(x, y)), made.value(x, y) == code);
    made.scale = 0.1;  // the code is what the file holds, whatever it stands for
    made.unit = "ft";
    EXPECT_EQ(std::isnan(read(make_tiff(folder("s.tif"), made)).heights(25, 25)), true) << code;
  }
}

/// A deep sea passes through -9999 m on its way down.
TEST(RealFiles, DepthsThatLookLikeACodeStay) {
  const TestFolder folder;
  Made made{.type = GDT_Int16};
  made.value = [](int x, int y) { return -9800.0 - 10 * x + y; };
  const Read got = read(make_tiff(folder("trench.tif"), made));
  EXPECT_THAT(got.notes, IsEmpty());
  EXPECT_EQ(got.heights(20, 1), -9999.0F);
}

TEST(RealFiles, HeightsThatCannotBeAreVoidsOrAnError) {
  const TestFolder folder;
  Made made;
  made.value = [](int x, int y) { return x == 3 && y == 4 ? 1e9 : 50.0; };
  EXPECT_TRUE(std::isnan(read(make_tiff(folder("one.tif"), made)).heights(3, 4)));
  made.value = [](int x, int) { return 80000.0 + x; };  // centimetres
  EXPECT_THAT(error_of([&] { read(make_tiff(folder("cm.tif"), made)); }), HasSubstr("another unit"));
  EXPECT_NEAR(read(folder("cm.tif"), {.unit = "cm"}).heights(10, 0), 800.1, 1e-3);
}

TEST(RealFiles, UnitsInAnySpelling) {
  for (const char* feet : {"ft", "Feet", "foot", "FEET", "[ft]", "Foot (International)", "ft (int)"})
    EXPECT_NEAR(metres_in_unit(feet).value_or(0), 0.3048, 1e-9) << feet;
  for (const char* survey : {"US survey foot", "ftUS", "us-ft", "US_survey_foot", "foot_us", "us ft"})
    EXPECT_NEAR(metres_in_unit(survey).value_or(0), 0.3048006096, 1e-9) << survey;
  for (const char* metre : {"m", "Metre", "meters", "METER", "[m]", "metre "}) EXPECT_EQ(metres_in_unit(metre), 1.0);
  EXPECT_EQ(metres_in_unit("smoot"), std::nullopt);
  const TestFolder folder;
  EXPECT_NEAR(read(make_tiff(folder("a.tif"), {.unit = "Feet"})).heights(1, 1), 30.48, 1e-4);
  EXPECT_NEAR(read(make_tiff(folder("b.tif"), {.crs = "EPSG:26910+6360"})).heights(1, 1), 30.48006, 1e-4);
  EXPECT_EQ(read(folder("b.tif")).heights.frame().crs, "EPSG:26910");
  EXPECT_THAT(error_of([&] { read(make_tiff(folder("c.tif"), {.unit = "smoot"})); }), HasSubstr("'smoot'"));
  EXPECT_NEAR(read(folder("c.tif"), {.unit = "fathoms"}).heights(1, 1), 182.88, 1e-3);
}

TEST(RealFiles, PicturesAreNoHeightsUnlessTheyCodeThem) {
  const TestFolder folder;
  Made made{.type = GDT_Byte, .bands = 3};
  const std::string path = make_tiff(folder("rgb.tif"), made);
  EXPECT_THAT(error_of([&] { read(path); }), HasSubstr("terrarium or mapbox"));
  EXPECT_EQ(read(path, {.band = 2}).heights(0, 0), 100.0F);
  EXPECT_NEAR(read(path, {.coding = ElevationCoding::terrarium}).heights(0, 0), 100 * 256 + 100 + 100 / 256.0 - 32768,
              1e-2);
  made.value = [](int, int) { return 2.0; };
  EXPECT_NEAR(read(make_tiff(path, made), {.coding = ElevationCoding::mapbox}).heights(0, 0),
              -10000 + (2 * 65536 + 2 * 256 + 2) * 0.1, 1e-2);
}

TEST(RealFiles, OptionsWithoutAPartAreRefused) {
  const TestFolder folder;
  std::vector<uint8_t> rgba;
  for (int i = 0; i < 64; ++i) rgba.insert(rgba.end(), {10, static_cast<uint8_t>(20 + i), 30, 255});
  write_bytes(folder("c.png"), encode_png8(rgba, 8, 8, 4));
  ReadOptions options{.cell_m = 10.0, .range = HeightRange{0, 255}};
  EXPECT_THAT(error_of([&] { read(folder("c.png"), options); }), HasSubstr("is a colour picture"));
  options.band = 2;
  EXPECT_NEAR(read(folder("c.png"), options).heights(3, 1), 31, 1e-3);
  options.band = 5;
  EXPECT_THAT(error_of([&] { read(folder("c.png"), options); }), HasSubstr("has 4 channels"));
  options.band = 2;
  options.unit = "feet";
  EXPECT_THAT(error_of([&] { read(folder("c.png"), options); }), HasSubstr("holds codes"));
  const std::string tiff = make_tiff(folder("h.tif"), {});
  EXPECT_THAT(error_of([&] { read(tiff, {.byte_order = ByteOrder::big}); }), HasSubstr("byte_order: is for raw files"));
  write_heights(read(tiff).heights, folder("h.npy"));
  EXPECT_THAT(error_of([&] { read(folder("h.npy"), {.band = 2}); }), HasSubstr("band: is for"));
  EXPECT_THAT(error_of([&] { read(folder("h.npy"), {.coding = ElevationCoding::mapbox}); }),
              HasSubstr("coding: is for"));
  EXPECT_EQ(read(folder("h.npy"), {.crs = "EPSG:32634"}).heights.frame().crs, "EPSG:32634");
}

/// A count that happens to be a code is no void of a field, nor is anything in a file of ours; a band in other units
/// than lengths can be looked at.
TEST(RealFiles, FieldsKeepTheirNumbers) {
  const TestFolder folder;
  Made made{.unit = "Celsius"};
  made.value = [](int x, int y) { return x == 3 && y == 4 ? 32767.0 : 20.0 + x; };
  const std::string path = make_tiff(folder("count.tif"), made);
  EXPECT_EQ(read_field(path)(3, 4), 32767.0F);
  EXPECT_THAT(raster_info(path).notes, testing::Contains(HasSubstr("Celsius")));
  ScalarField ours(GridFrame::centred(4, 4, 10.0), 1.0F);
  ours(1, 1) = -9999.0F;
  for (const char* name : {"ours.tif", "ours.npy"}) {
    write_field(ours, folder(name));
    EXPECT_EQ(read_field(folder(name)), ours) << name;
  }
}

/// A quarry as a drone sees it, in metres of its own: steep, but no degrees.
TEST(RealFiles, SteepModelsInLocalMetresAreNoDegrees) {
  const TestFolder folder;
  Made made{.transform = {0, 0.1, 0, 5, 0, -0.1}, .crs = ""};
  made.value = [](int x, int) { return x < 30 ? 0.0 : 12.0; };
  const Read quarry = read(make_tiff(folder("quarry.tif"), made));
  EXPECT_THAT(quarry.notes, IsEmpty());
  EXPECT_NEAR(quarry.heights.cell_m(), 0.1, 1e-9);
}

/// The same ground in tiles of the web, joined by their names, and as one raster of Web Mercator.
TEST(RealFiles, SlippyTilesLieWhereTheirNamesSay) {
  const TestFolder folder;
  const auto tile = [&](int column, int row) {
    Made made{.width = 64, .height = 64, .type = GDT_Byte, .bands = 3};
    const std::string path = folder("12_" + std::to_string(column) + "_" + std::to_string(row) + ".png");
    std::vector<uint8_t> rgb;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const int code = 32768 * 256 + 256 * ((column - 2138) * 64 + x) + 256 * ((row - 1420) * 64 + y);
        rgb.insert(rgb.end(), {static_cast<uint8_t>(code >> 16), static_cast<uint8_t>(code >> 8 & 255),
                               static_cast<uint8_t>(code & 255)});
      }
    }
    write_bytes(path, encode_png8(rgb, 64, 64, 3));
    return path;
  };
  const std::string a = tile(2138, 1420), b = tile(2139, 1420);
  const ReadOptions options{.coding = ElevationCoding::terrarium};
  const HeightField one = read_heights(a, options), both = read_joined_heights({a, b}, options);
  const double side = 40075016.6856 / 4096 * std::cos(48.4 * 3.14159265 / 180);
  EXPECT_NEAR(one.frame().width_m(), side, 0.02 * side);
  EXPECT_NEAR(both.frame().width_m(), 2 * side, 0.04 * side);
  const int y = both.height() / 2;
  for (int x = 4; x + 4 < both.width(); ++x)  // no step where the two meet
    ASSERT_NEAR(both(x + 1, y) - both(x, y), both.cell_m() * 64 / side, 0.2) << x;
}

TEST(RealFiles, DegreesWithoutASystemAreSaid) {
  const TestFolder folder;
  std::string text = "ncols 7\nnrows 6\nxllcorner -156.5\nyllcorner 18.9\ncellsize 0.0833333\n";
  for (int i = 0; i < 42; ++i) text += std::to_string(100 + 7 * i) + ".0 ";
  write_text(folder("five.asc"), text);
  const Read degrees = read(folder("five.asc"));
  EXPECT_THAT(degrees.notes, ElementsAre(HasSubstr("can only be degrees")));
  EXPECT_NEAR(degrees.heights.cell_m(), 9000, 300);
  EXPECT_NEAR(read(folder("five.asc"), {.crs = "local"}).heights.cell_m(), 0.0833333, 1e-9);
  write_text(folder("model.asc"),
             "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.1\n0.01 0.02 0.03\n0 0.01 0.02\n");
  EXPECT_THAT(read(folder("model.asc")).notes, IsEmpty());
}

TEST(RealFiles, TheOtherByteOrderIsSaid) {
  const TestFolder folder;
  std::vector<uint8_t> big;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const int code = 20000 + 40 * x + 25 * y;
      big.insert(big.end(), {static_cast<uint8_t>(code >> 8), static_cast<uint8_t>(code & 255)});
    }
  }
  write_bytes(folder("big.r16"), big);
  ReadOptions options{.cell_m = 10.0, .range = HeightRange{0, 6553.5}};
  EXPECT_THAT(read(folder("big.r16"), options).notes, ElementsAre(HasSubstr("byte_order \"big\"")));
  options.byte_order = ByteOrder::big;
  const Read right = read(folder("big.r16"), options);
  EXPECT_THAT(right.notes, IsEmpty());
  EXPECT_NEAR(right.heights(10, 4), 2050, 0.01);
}

/// Sheets of one lattice come together to the bit, with their holes, also across the 180th meridian.
TEST(Join, SheetsOfOneLatticeMeetWithoutASeam) {
  const TestFolder folder;
  const auto value = [](int x, int y) { return x % 13 == 5 && y % 11 == 3 ? -9999.0 : 10.0 * x + y; };
  Made west, east;
  west.value = value;
  east.transform[0] += 590;  // one column in common
  east.value = [&](int x, int y) { return value(x + 59, y); };
  const std::string a = make_tiff(folder("a.tif"), west), b = make_tiff(folder("b.tif"), east);
  for (const auto& files : {std::vector{a, b}, std::vector{b, a}}) {
    const HeightField both = read_joined_heights(files);
    ASSERT_EQ(both.width(), 119);
    EXPECT_EQ(both.frame().west_m, 5e5);
    EXPECT_EQ(both.frame().crs, "EPSG:32633");
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 119; ++x) {
        ASSERT_EQ(std::isnan(both(x, y)), value(x, y) < 0) << x << " " << y;
        if (value(x, y) >= 0) {
          ASSERT_EQ(both(x, y), value(x, y)) << x << " " << y;
        }
      }
    }
  }
  Made before{.transform = {179.7, 0.005, 0, 10, 0, -0.005}, .crs = "EPSG:4326"}, after = before;
  after.transform[0] = -180;
  const auto place = [](const Made& made) {
    return [west_edge = made.transform[0]](int x, int y) {
      const double longitude = west_edge + (x + 0.5) * 0.005;
      return by_place(longitude < 0 ? longitude + 360 : longitude, 10 - (y + 0.5) * 0.005);
    };
  };
  before.value = place(before), after.value = place(after);
  const HeightField across =
      read_joined_heights({make_tiff(folder("before.tif"), before), make_tiff(folder("after.tif"), after)});
  EXPECT_GT(across.width(), 100);
  expect_right_places(across, 0.002);
}

TEST(Join, OtherLatticesAreReadBetweenTheirCells) {
  const TestFolder folder;
  Made first, second;
  first.value = [](int x, int y) { return 10.0 * x + y; };
  second.transform = {5e5 + 603, 7, 0, 4e6, 0, -7};
  second.value = [](int x, int y) { return (603 + 7 * (x + 0.5)) - 5 + 0.7 * (y + 0.5) - 0.5; };
  const HeightField both = read_joined_heights({make_tiff(folder("a.tif"), first), make_tiff(folder("b.tif"), second)});
  for (int x = 0; x < both.width() - 1; ++x) {
    if (x == 60) continue;  // a gap of 3 m: known to one side or not at all
    ASSERT_NEAR(both(x, 20), 10.0 * x + 20, 1e-2) << x;
  }
  EXPECT_THAT(error_of([&] { read_joined_heights({}); }), HasSubstr("names no file"));
}

}  // namespace
}  // namespace seamount::io

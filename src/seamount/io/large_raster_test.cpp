// Rasters read window by window against the same files read as a whole: equal bytes, equal notes.
#include "seamount/io/large_raster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

struct Made {
  const char* name;
  std::array<double, 6> transform = {5e5, 10, 0, 4e6, 0, -10};
  const char* crs = "EPSG:32633";
  GDALDataType type = GDT_Float32;
  const char* unit = "";
  double scale = 1.0, offset = 0.0;
  std::optional<double> nodata = {};
  bool blocks = false;  ///< of 64 x 64 cells; else rows
  double odd = 0.0;     ///< a value of some cells
  ReadOptions options = {};
};

double height_at(int x, int y) {
  return 900 * std::sin(0.031 * x) * std::cos(0.045 * y) + 0.37 * ((x * 7 + y * 13) % 29);
}

constexpr int kWidth = 331, kHeight = 277;

void make_tiff(const std::string& path, const Made& made) {
  const GdalCall call(path);
  CPLStringList how;
  if (made.blocks) {
    for (const char* option : {"TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64", "COMPRESS=DEFLATE"})
      how.AddString(option);
  }
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const DatasetPtr dataset(driver->Create(path.c_str(), kWidth, kHeight, 1, made.type, how.List()));
  std::array<double, 6> transform = made.transform;
  dataset->SetGeoTransform(transform.data());
  if (const auto system = parse_crs(made.crs)) dataset->SetSpatialRef(system.get());
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  if (made.unit[0] != '\0') band.SetUnitType(made.unit);
  if (made.scale != 1.0) band.SetScale(made.scale);
  if (made.offset != 0.0) band.SetOffset(made.offset);
  if (made.nodata) band.SetNoDataValue(*made.nodata);
  std::vector<double> row(kWidth);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool hole = std::hypot(x - 200, y - 90) < 20;
      row[static_cast<size_t>(x)] = hole && made.odd != 0.0 ? made.odd : height_at(x, y);
    }
    EXPECT_EQ(band.RasterIO(GF_Write, 0, y, kWidth, 1, row.data(), kWidth, 1, GDT_Float64, 0, 0), CE_None);
  }
}

const std::vector<Made>& cases() {
  static const std::vector<Made> kCases = [] {
    constexpr std::array<double, 6> kDegrees = {12.3, 0.0007, 0, 46.5, 0, -0.0007};
    ReadOptions local, feet, into;
    local.crs = "local";
    feet.unit = "feet";
    into.into = "EPSG:32632";
    std::vector<Made> made = {{"as_it_is"},
                              {"blocks"},
                              {"declared_voids"},
                              {"usual_code"},
                              {"value_that_looks_like_a_code"},
                              {"whole_numbers"},
                              {"feet"},
                              {"told_feet"},
                              {"scaled"},
                              {"impossible"},
                              {"south_up"},
                              {"east_first"},
                              {"oblong"},
                              {"degrees"},
                              {"degrees_into"},
                              {"degrees_unsaid"},
                              {"mercator_far_north"},
                              {"near_the_pole"}};
    made[1].blocks = true;
    made[2].nodata = made[2].odd = -1;
    made[3].odd = -9999, made[3].blocks = true;
    made[4].odd = -9990, made[4].transform[1] = 10;
    made[5].type = GDT_Int16, made[5].odd = -32768;
    made[6].unit = "ft", made[6].odd = 3.4e38;
    made[7].options = feet;
    made[8].type = GDT_Int16, made[8].scale = 0.5, made[8].offset = 100, made[8].odd = -32767;
    made[9].odd = 45000;
    made[10].transform = {5e5, 10, 0, 4e6, 0, 10}, made[10].blocks = true;
    made[11].transform = {5e5, -10, 0, 4e6, 0, -10};
    made[12].transform = {5e5, 10, 0, 4e6, 0, -7}, made[12].odd = -9999;
    made[13].transform = kDegrees, made[13].crs = "EPSG:4326", made[13].blocks = true, made[13].odd = -9999;
    made[14] = made[13], made[14].name = "degrees_into", made[14].options = into;
    made[15].transform = kDegrees, made[15].crs = "";
    made[16].transform = {1e6, 30, 0, 9e6, 0, -30}, made[16].crs = "EPSG:3857";
    made[17].transform = {-40, 0.05, 0, 89.5, 0, -0.004}, made[17].crs = "EPSG:4326";
    return made;
  }();
  return kCases;
}

class LargeRasterTest : public ::testing::TestWithParam<Made> {};

TEST_P(LargeRasterTest, HasTheCellsOfTheWhole) {
  const TestFolder folder;
  const std::string path = folder("made.tif");
  make_tiff(path, GetParam());
  std::vector<std::string> notes, expected;
  ReadOptions options = GetParam().options;
  options.run.note = [&](const std::string& line) { expected.push_back(line); };
  const HeightField whole = read_heights(path, options);
  options.run.note = [&](const std::string& line) { notes.push_back(line); };
  const LargeRaster raster(path, options);
  ASSERT_EQ(raster.frame(), whole.frame());
  EXPECT_EQ(notes.size(), expected.size());
  EXPECT_EQ(stored_size(path), std::pair(kWidth, kHeight));
  const int width = whole.width(), height = whole.height();
  for (const auto& [w, h] : {std::pair{width, height}, {97, 61}, {width, 50}, {16, 301}}) {
    for (int row = 0; row < height; row += h) {
      for (int column = 0; column < width; column += w) {
        const GridFrame window =
            raster.frame().window(column, row, std::min(w, width - column), std::min(h, height - row));
        const HeightField part = raster.read(window, {});
        for (int y = 0; y < window.height; ++y)
          ASSERT_EQ(std::memcmp(part.row(y).data(), &whole(column, row + y), sizeof(float) * part.row(y).size()), 0)
              << "row " << row + y << " from column " << column << " in windows of " << w << " x " << h;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, LargeRasterTest, ::testing::ValuesIn(cases()),
                         [](const ::testing::TestParamInfo<Made>& one) { return std::string(one.param.name); });

std::string error_of(const std::string& path, const ReadOptions& options = {}) {
  try {
    const LargeRaster raster(path, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(LargeRaster, RefusesWhatOnlyTheWholeCanTell) {
  const TestFolder folder;
  Made codes{"codes"};
  codes.type = GDT_UInt16;
  make_tiff(folder("codes.tif"), codes);
  EXPECT_THAT(error_of(folder("codes.tif")), ::testing::HasSubstr("codes of uint16"));
  Made space{"space"};
  space.odd = 0, space.scale = 1e5;
  make_tiff(folder("space.tif"), space);
  EXPECT_THAT(error_of(folder("space.tif")), ::testing::HasSubstr("more than 30 km from sea level"));
  EXPECT_THAT(error_of(folder("none.tif")), ::testing::HasSubstr("none.tif"));
}

}  // namespace
}  // namespace seamount::io

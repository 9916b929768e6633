#include "seamount/io/current_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

struct Band {
  std::string name, unit;
  float value;
};

/// A GeoTIFF of bands that hold one value each.
std::string write_bands(const std::string& path, const std::vector<Band>& bands, const std::string& crs, double cell,
                        double west, double north, int size = 16) {
  const GdalCall call(path);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const DatasetPtr dataset(
      driver->Create(path.c_str(), size, size, static_cast<int>(bands.size()), GDT_Float32, nullptr));
  double transform[] = {west, cell, 0, north, 0, -cell};
  dataset->SetGeoTransform(transform);
  if (const auto system = parse_crs(crs)) dataset->SetSpatialRef(system.get());
  std::vector<float> row(static_cast<size_t>(size));
  for (size_t b = 0; b < bands.size(); ++b) {
    GDALRasterBand& band = *dataset->GetRasterBand(static_cast<int>(b) + 1);
    band.SetDescription(bands[b].name.c_str());
    if (!bands[b].unit.empty()) band.SetUnitType(bands[b].unit.c_str());
    std::fill(row.begin(), row.end(), bands[b].value);
    for (int y = 0; y < size; ++y)
      EXPECT_EQ(band.RasterIO(GF_Write, 0, y, size, 1, row.data(), size, 1, GDT_Float32, 0, 0, nullptr), CE_None);
  }
  return path;
}

TEST(CurrentFile, ComesBackExactly) {
  const TestFolder folder;
  GridFrame frame{37, 21, 25.0, 300000.0, 5000000.0, "EPSG:32631"};
  VectorField current{ScalarField(frame), ScalarField(frame)};
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 37; ++x) {
      current.x(x, y) = 0.01F * static_cast<float>(x) - 0.2F;
      current.y(x, y) = 0.003F * static_cast<float>(y * x);
    }
  const std::string path = folder("current.tif");
  write_current(current, path);
  EXPECT_EQ(read_current(path), current);
  current.x(3, 4) = std::numeric_limits<float>::quiet_NaN();
  write_current(current, path);
  const VectorField back = read_current(path);
  EXPECT_TRUE(std::isnan(back.x(3, 4)));
  EXPECT_TRUE(std::isnan(back.y(3, 4)));  // what lacks one component lacks both
  EXPECT_EQ(back.y(4, 4), current.y(4, 4));
}

TEST(CurrentFile, KnowsBandsAndUnits) {
  const TestFolder folder;
  std::string said;
  ReadOptions options;
  options.run.note = [&](const std::string& line) { said += line + "\n"; };
  const std::string path = folder("c.tif");
  const auto read = [&](const std::vector<Band>& bands) {
    return read_current(write_bands(path, bands, "EPSG:32631", 100, 400000, 5000000), options);
  };
  EXPECT_EQ(read({{"northward", "", 2.0F}, {"eastward", "", 1.0F}}).x(0, 0), 1.0F);
  EXPECT_EQ(read({{"depth", "", 9.0F}, {"vo", "m s-1", 2.0F}, {"uo", "m s-1", 1.0F}}).y(0, 0), 2.0F);
  EXPECT_EQ(said, "");
  EXPECT_NEAR(read({{"u", "cm/s", 50.0F}, {"v", "cm/s", 0.0F}}).x(0, 0), 0.5F, 1e-6F);
  EXPECT_NE(said.find("cm/s are converted"), std::string::npos);
  EXPECT_NEAR(read({{"u", "knots", 1.0F}, {"v", "knots", 0.0F}}).x(0, 0), 0.514444F, 1e-5F);
  EXPECT_EQ(read({{"", "", 3.0F}, {"", "", 4.0F}, {"", "", 5.0F}}).y(0, 0), 4.0F);
  EXPECT_NE(said.find("the first two of 3"), std::string::npos);
  EXPECT_THROW(read({{"u", "", 1.0F}}), IoError);
  EXPECT_THROW(read({{"u", "degrees", 1.0F}, {"v", "degrees", 1.0F}}), IoError);
  EXPECT_THROW(read({{"u", "m/s", 1.0F}, {"v", "cm/s", 1.0F}}), IoError);
  EXPECT_THROW(read_current(folder("c.png")), IoError);
}

TEST(CurrentFile, VectorsTurnWithTheAxes) {
  // At 70 N, 3 degrees of longitude west of a zone's middle, grid north lies 3 sin(70) = 2.8 degrees off true north.
  const GridFrame geographic_like{40, 40, 500.0, 385000.0, 7780000.0, "EPSG:32633"};
  const VectorField current{ScalarField(geographic_like, 0.0F), ScalarField(geographic_like, 1.0F)};
  const VectorField other = in_system(current, "EPSG:32632", {});
  const int x = other.x.width() / 2, y = other.x.height() / 2;
  EXPECT_NEAR(std::hypot(other.x(x, y), other.y(x, y)), 1.0F, 1e-4F);
  const double degrees = std::atan2(other.x(x, y), other.y(x, y)) * 180.0 / 3.14159265358979;
  EXPECT_NEAR(std::abs(degrees), 6.0 * std::sin(70.1 / 57.29578), 0.05);
  const VectorField back = on_cells(other, GridFrame{10, 10, 500.0, 392500.0, 7772500.0, "EPSG:32633"}, {});
  EXPECT_NEAR(back.x(5, 5), 0.0F, 1e-3F);
  EXPECT_NEAR(back.y(5, 5), 1.0F, 1e-3F);
}

TEST(CurrentFile, OfARasterInDegreesNorthStaysNorth) {
  const TestFolder folder;
  const std::string path =
      write_bands(folder("d.tif"), {{"u", "", 0.0F}, {"v", "", 1.0F}}, "EPSG:4326", 0.01, 8.0, 71.0, 64);
  ReadOptions options;
  options.into = "EPSG:32633";  // middle at 15 E: at 8.3 E grid north is 6.3 degrees off
  const VectorField current = read_current(path, options);
  const GridFrame& frame = current.frame();
  EXPECT_EQ(frame.crs, "EPSG:32633");
  const int x = frame.width / 2, y = frame.height / 2;
  EXPECT_NEAR(std::atan2(current.x(x, y), current.y(x, y)) * 57.29578, 6.68 * std::sin(70.68 / 57.29578), 0.1);
}

}  // namespace
}  // namespace seamount::io

// Contours as GDAL draws them of a raster, read and made a terrain again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "seamount/geom/scalar/noise.h"
#include "seamount/io/projection.h"
#include "seamount/io/test_sheet.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/recipe/contour_file.h"

namespace seamount::recipe {
namespace {

using io::Sheet, io::write_contours;

/// Whole metres, as elevation models hold them: many cells lie at a contour's very height.
std::vector<float> whole_metres(int side, uint64_t seed) {
  std::vector<float> heights(static_cast<size_t>(side) * static_cast<size_t>(side));
  const geom::Fbm shape{.wavelength_m = 0.7 * side, .octaves = 5, .gain = 0.45, .cell_m = 1.0};
  for (int y = 0; y < side; ++y) {
    const std::span<float> row(heights.data() + static_cast<size_t>(y) * static_cast<size_t>(side),
                               static_cast<size_t>(side));
    geom::fbm_row(Seed{seed}, shape, 0.0, 1.0, y, row);
    for (float& z : row) z = std::round(260.0F * z);
  }
  return heights;
}

/// The share of a terrain's cells that differ by more than the interval from the raster, read between its cells.
double share_beyond(const HeightField& terrain, const Sheet& sheet, const std::vector<float>& heights, int side,
                    double interval) {
  const GridFrame& frame = terrain.frame();
  std::vector<Vec2> places;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) places.push_back({frame.x(x), frame.y(y)});
  if (sheet.crs == "EPSG:4326") places = io::to_lonlat(places, frame.crs);
  size_t beyond = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    const double u = std::clamp((places[i].x - sheet.west) / sheet.cell - 0.5, 0.0, side - 1.001);
    const double v = std::clamp((sheet.north - places[i].y) / sheet.cell - 0.5, 0.0, side - 1.001);
    const auto x = static_cast<size_t>(u), y = static_cast<size_t>(v);
    const double s = u - static_cast<double>(x), t = v - static_cast<double>(y);
    const auto at = [&](size_t dx, size_t dy) {
      return static_cast<double>(heights[(y + dy) * static_cast<size_t>(side) + x + dx]);
    };
    const double z = (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1));
    if (std::abs(z - static_cast<double>(terrain.cells()[i])) > interval) ++beyond;
  }
  return static_cast<double>(beyond) / static_cast<double>(places.size());
}

TEST(SheetContours, OfGdalGiveTheTerrainBack) {
  constexpr int kSide = 180;
  constexpr double kInterval = 20.0;
  const std::string path = (std::filesystem::temp_directory_path() / "seamount_sheet_contours.gpkg").string();
  for (const Sheet& sheet : {Sheet{"EPSG:32632", 500000, 5200000, 30}, Sheet{"EPSG:4326", 8, 47, 1.0 / 180},
                             Sheet{"EPSG:4326", -70, -40, 1.0 / 1200}}) {
    for (const uint64_t seed : {1U, 2U, 3U, 4U}) {
      std::filesystem::remove(path);
      const std::vector<float> heights = whole_metres(kSide, seed);
      ASSERT_TRUE(write_contours(path, sheet, heights, kSide, kInterval));
      std::vector<std::string> notes;
      RunContext run;
      run.note = [&](const std::string& line) { notes.push_back(line); };
      const ContourSet set = contours_of_file(path, {}, GridFrame::centred(kSide, kSide, 10), run);
      EXPECT_THAT(notes, ::testing::ElementsAre(::testing::HasSubstr("the field 'ELEV'"))) << "no side is a guess";
      EXPECT_GT(set.frame.width_m() * set.frame.height_m(), 0);
      const HeightField terrain = contour::reconstruct(set, {}, {});
      EXPECT_LT(share_beyond(terrain, sheet, heights, kSide, kInterval), 0.001) << sheet.crs << ", seed " << seed;
    }
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace seamount::recipe

// Random rasters of many systems, units, flips, voids and bands, read here and warped by GDAL onto the same cells.
// SEAMOUNT_WARPS=1000 makes a thousand of them.
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct System {
  const char* crs;
  double west, east, south, north;  ///< degrees in which it is used
  double cell_low, cell_high;       ///< units of the system
};

constexpr std::array<System, 14> kSystems = {{{"EPSG:4326", -179, 179, -70, 70, 0.0003, 0.01},
                                              {"EPSG:4269", -120, -70, 25, 50, 0.0003, 0.01},
                                              {"EPSG:4258", -10, 30, 36, 65, 0.0003, 0.01},
                                              {"EPSG:32601", -179, -174, -5, 70, 5, 200},
                                              {"EPSG:32633", 12, 18, 0, 70, 5, 200},
                                              {"EPSG:32719", -72, -66, -60, 0, 5, 200},
                                              {"EPSG:3857", -179, 179, -65, 65, 10, 300},
                                              {"EPSG:3035", -8, 30, 38, 65, 10, 300},
                                              {"EPSG:2193", 167, 178, -46, -35, 5, 200},
                                              {"EPSG:27700", -6, 1, 50, 58, 5, 200},
                                              {"EPSG:2926", -124, -118, 47, 49, 20, 500},
                                              {"EPSG:3031", -180, 180, -85, -66, 50, 400},
                                              {"EPSG:5070", -120, -75, 25, 48, 10, 300},
                                              {"EPSG:3395", -179, 179, -60, 60, 10, 300}}};

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits = {
    {{"", 1.0}, {"m", 1.0}, {"Feet", 0.3048}, {"US survey foot", 1200.0 / 3937.0}, {"km", 1000.0}}};

/// A raster in a file, and the same with its true heights for GDAL.
struct Made {
  std::string path;
  int band = 0;  ///< to be named; 0: the only one
  DatasetPtr truth;
};

Made make(const std::string& folder, uint64_t seed) {
  Rng rng(Seed{seed}.derive("warp"));
  const auto pick = [&](const auto& list) -> const auto& {
    return list[static_cast<size_t>(rng.uniform(0, list.size()))];
  };
  const System& system = pick(kSystems);
  const Vec2 lonlat{rng.uniform(system.west, system.east), rng.uniform(system.south, system.north)};
  const auto crs = parse_crs(system.crs);
  Vec2 middle = lonlat;
  {
    const OGRSpatialReference degrees = lonlat_system();
    const TransformPtr way(OGRCreateCoordinateTransformation(&degrees, crs.get()));
    way->Transform(1, &middle.x, &middle.y);
  }
  const int width = static_cast<int>(rng.uniform(20, 120)), height = static_cast<int>(rng.uniform(20, 120));
  const double cell_x = std::exp(rng.uniform(std::log(system.cell_low), std::log(system.cell_high)));
  const double cell_y = rng.chance(0.5) ? cell_x : cell_x * rng.uniform(0.6, 1.6);
  const bool south_up = rng.chance(0.25), east_first = rng.chance(0.15);
  std::array<double, 6> transform{middle.x - 0.5 * width * cell_x * (east_first ? -1 : 1),
                                  east_first ? -cell_x : cell_x,
                                  0,
                                  middle.y + 0.5 * height * cell_y * (south_up ? -1 : 1),
                                  0,
                                  south_up ? cell_y : -cell_y};
  const Unit& unit = pick(kUnits);
  const bool scaled = rng.chance(0.3);
  const double scale = scaled ? 0.1 : 1.0, offset = scaled ? 25.0 : 0.0;
  const int how_void = static_cast<int>(rng.uniform(0, 4));  // none, tagged, the usual code without a tag, 3.4e38
  const double code = how_void == 1 ? -500000.0 : how_void == 2 ? -9999.0 : static_cast<double>(-3.4028235e38F);
  const int bands = rng.chance(0.2) ? 2 : 1, band = bands;
  const double ax = rng.uniform(-0.1, 0.1), ay = rng.uniform(-0.1, 0.1), hole_x = rng.uniform(0, width),
               hole_y = rng.uniform(0, height), hole = rng.uniform(2, 12);
  GdalCall call("made");
  Made made{folder + "/r" + std::to_string(seed) + ".tif", bands > 1 ? band : 0, nullptr};
  const DatasetPtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(made.path.c_str(), width, height,
                                                                                 bands, GDT_Float32, nullptr));
  made.truth.reset(GetGDALDriverManager()->GetDriverByName("MEM")->Create("", width, height, 1, GDT_Float32, nullptr));
  for (GDALDataset* dataset : {file.get(), made.truth.get()}) {
    dataset->SetGeoTransform(transform.data());
    dataset->SetSpatialRef(crs.get());
  }
  GDALRasterBand& stored = *file->GetRasterBand(band);
  if (*unit.name != '\0') stored.SetUnitType(unit.name);
  if (scaled) stored.SetScale(scale), stored.SetOffset(offset);
  if (how_void == 1) stored.SetNoDataValue(code);
  made.truth->GetRasterBand(1)->SetNoDataValue(kNone);
  std::vector<float> raw(static_cast<size_t>(width)), heights(raw.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double z = 300 + 120 * std::sin(ax * x + 0.3) * std::cos(ay * y) + 2 * ax * x;
      const bool unknown = how_void > 0 && std::hypot(x - hole_x, y - hole_y) < hole;
      const auto i = static_cast<size_t>(x);
      raw[i] = unknown ? static_cast<float>(code) : static_cast<float>((z / unit.metres - offset) / scale);
      heights[i] = unknown ? kNone : static_cast<float>(z);
    }
    EXPECT_EQ(stored.RasterIO(GF_Write, 0, y, width, 1, raw.data(), width, 1, GDT_Float32, 0, 0), CE_None);
    EXPECT_EQ(
        made.truth->GetRasterBand(1)->RasterIO(GF_Write, 0, y, width, 1, heights.data(), width, 1, GDT_Float32, 0, 0),
        CE_None);
  }
  return made;
}

/// GDAL's own warp at the middles of a frame's cells. It averages where cells grow larger, also along one axis only, so
/// it is asked for cells of a third and the middle one of nine is taken.
HeightField warped_by_gdal(GDALDataset& truth, const GridFrame& wanted) {
  constexpr int kFiner = 3;
  GridFrame frame = wanted;
  frame.width *= kFiner;
  frame.height *= kFiner;
  frame.cell_m /= kFiner;
  const GdalCall call("warp");
  std::vector<std::string> words = {"-of",        "MEM", "-r",     "bilinear", "-et", "0",
                                    "-dstnodata", "nan", "-t_srs", frame.crs,  "-te"};
  for (const double edge : {frame.west_m, frame.south_m(), frame.east_m(), frame.north_m})
    words.push_back(std::to_string(edge));
  words.insert(words.end(), {"-ts", std::to_string(frame.width), std::to_string(frame.height)});
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  GDALWarpAppOptions* options = GDALWarpAppOptionsNew(arguments.data(), nullptr);
  GDALDatasetH source = &truth;
  int misuse = 0;
  const DatasetPtr warped(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &source, options, &misuse)));
  GDALWarpAppOptionsFree(options);
  HeightField heights(frame, kNone), middles(wanted, kNone);
  if (!warped) return middles;
  EXPECT_EQ(warped->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, frame.width, frame.height, heights.data(), frame.width,
                                               frame.height, GDT_Float32, 0, 0),
            CE_None);
  for (int y = 0; y < wanted.height; ++y)
    for (int x = 0; x < wanted.width; ++x) middles(x, y) = heights(kFiner * x + 1, kFiner * y + 1);
  return middles;
}

TEST(WarpAgainstGdal, PlacesAndHeightsAgree) {
  const char* many = std::getenv("SEAMOUNT_WARPS");
  const int count = many != nullptr ? std::atoi(many) : 60;
  const TestFolder folder;
  int64_t compared = 0, apart = 0, voids_apart = 0, rim = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const Made made = make(folder(""), static_cast<uint64_t>(i));
    ReadOptions options;
    if (made.band > 0) options.band = made.band;
    const HeightField ours = read_heights(made.path, options);
    ASSERT_FALSE(ours.frame().crs.empty()) << i;
    const HeightField theirs = warped_by_gdal(*made.truth, ours.frame());
    for (int y = 1; y + 1 < ours.height(); ++y) {  // GDAL has nothing within half a cell of the edge
      for (int x = 1; x + 1 < ours.width(); ++x) {
        const float a = ours(x, y), b = theirs(x, y);
        bool near_void = false;
        for (int k = 0; k < 9; ++k) near_void |= std::isnan(ours(x + k % 3 - 1, y + k / 3 - 1));
        if (near_void) {
          ++rim;
          continue;
        }
        if (std::isnan(b)) {
          ++voids_apart;
          continue;
        }
        ++compared;
        const double difference = std::abs(static_cast<double>(a) - static_cast<double>(b));
        worst = std::max(worst, difference);
        apart += difference > 0.5 ? 1 : 0;
      }
    }
    std::remove(made.path.c_str());
  }
  EXPECT_GT(compared, 1000 * count);
  EXPECT_EQ(apart, 0) << "of " << compared << ", worst " << worst << " m";
  EXPECT_LE(voids_apart, compared / 1000) << "known here, unknown to GDAL";
  RecordProperty("worst_m", std::to_string(worst));
  if (many != nullptr) std::printf("%d rasters, %ld cells, worst %.4f m\n", count, static_cast<long>(compared), worst);
}

}  // namespace
}  // namespace seamount::io

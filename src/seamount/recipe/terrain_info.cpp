#include "seamount/recipe/terrain_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/io/holds_heights.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster.h"
#include "seamount/ops/hydrology/peaks.h"
#include "seamount/recipe/degrees.h"
#include "seamount/recipe/file_values.h"

namespace seamount::recipe {
namespace {

constexpr size_t kMostCells = 25'000'000;
constexpr size_t kMostPeaks = 5;
constexpr double kLeastShare = 0.02;

std::string tenths(double value) { return format_number(std::round(value * 10) / 10 + 0.0); }

std::string place_text(Vec2 place) { return "x " + tenths(place.x) + " m, y " + tenths(place.y) + " m"; }

std::string lonlat_text(Vec2 place, const std::string& crs) {
  const Vec2 degrees = io::to_lonlat({place}, crs).front();
  return fmt::format("longitude {:.5f}, latitude {:.5f}", degrees.x, degrees.y);
}

Vec2 place_of(const GridFrame& frame, const Asked& asked) {
  if (!asked.lonlat) return asked.place;
  if (frame.crs.empty()) throw InvalidArgument("at", "the file has no coordinate system: give metres");
  return io::from_lonlat({asked.place}, frame.crs).front();
}

void check_inside(const GridFrame& frame, Vec2 place) {
  if (place.x >= frame.west_m && place.x <= frame.east_m() && place.y >= frame.south_m() && place.y <= frame.north_m)
    return;
  throw InvalidArgument(
      "at", fmt::format("{} lies beside the file, which covers x {} to {} m and y {} to {} m", place_text(place),
                        tenths(frame.west_m), tenths(frame.east_m()), tenths(frame.south_m()), tenths(frame.north_m)));
}

/// The value of the cell around a place.
template <class T>
T cell_at(const Grid<T>& grid, Vec2 place) {
  const GridFrame& frame = grid.frame();
  const auto nearest = [](double at, int count) { return std::clamp(static_cast<int>(std::lround(at)), 0, count - 1); };
  return grid(nearest(frame.column(place.x), frame.width), nearest(frame.row(place.y), frame.height));
}

std::string region_at(const std::string& file, const GridFrame& frame, Vec2 place) {
  const LabelMap labels = is_picture(file) ? read_label_picture(file, frame, {}) : io::read_labels(file);
  const GridFrame& own = labels.frame();
  if (place.x < own.west_m || place.x > own.east_m() || place.y < own.south_m() || place.y > own.north_m)
    return "none: the place lies beside the labels";
  return std::string(region_name(cell_at(labels, place)));
}

/// Where a frame lies: its sides in metres, and in degrees.
io::FileInfo sides_of(const GridFrame& frame) {
  io::FileInfo info;
  info.emplace_back("covers", fmt::format("x {} to {} m, y {} to {} m", tenths(frame.west_m), tenths(frame.east_m()),
                                          tenths(frame.south_m()), tenths(frame.north_m)));
  if (!frame.crs.empty()) info.emplace_back("on the globe", degrees_text(frame));
  return info;
}

io::FileInfo peaks_of(HeightField terrain) {
  float lowest = INFINITY, highest = -INFINITY;
  for (const float height : terrain.cells())
    if (std::isfinite(height)) lowest = std::min(lowest, height), highest = std::max(highest, height);
  if (!(highest > std::max(lowest, 0.0F))) return {};
  for (float& height : terrain.cells())
    if (!std::isfinite(height)) height = lowest;
  const double relief = static_cast<double>(highest) - std::max(0.0, static_cast<double>(lowest));
  auto peaks = hydrology::find_peaks(terrain, 0.0F, kLeastShare * relief, {});
  std::stable_sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.height_m > b.height_m; });
  io::FileInfo info;
  const GridFrame& frame = terrain.frame();
  for (size_t i = 0; i < std::min(peaks.size(), kMostPeaks); ++i) {
    const auto row = peaks[i].cell / frame.width, column = peaks[i].cell % frame.width;
    const Vec2 place{frame.x(static_cast<double>(column)), frame.y(static_cast<double>(row))};
    std::string line = tenths(peaks[i].height_m) + " m at " + place_text(place);
    if (!frame.crs.empty()) line += " (" + lonlat_text(place, frame.crs) + ")";
    info.emplace_back(fmt::format("peak {}", i + 1), line + ", prominence " + tenths(peaks[i].prominence_m) + " m");
  }
  return info;
}

}  // namespace

io::FileInfo describe_terrain(const std::string& path) {
  if (!io::holds_heights(path)) return {};
  if (const io::RasterInfo raster = io::raster_info(path);
      static_cast<size_t>(raster.width) * static_cast<size_t>(raster.height) > kMostCells)
    return {};
  HeightField terrain = io::read_heights(path);
  io::FileInfo info = sides_of(terrain.frame());
  const io::FileInfo peaks = peaks_of(std::move(terrain));
  info.insert(info.end(), peaks.begin(), peaks.end());
  return info;
}

io::FileInfo describe_place(const std::string& path, const Asked& asked) {
  const bool heights = io::holds_heights(path);
  const ScalarField field = heights ? io::read_heights(path) : io::read_field(path);
  const GridFrame& frame = field.frame();
  const Vec2 place = place_of(frame, asked);
  check_inside(frame, place);
  io::FileInfo info{{"file", path}, {"place", place_text(place)}};
  if (!frame.crs.empty()) info.emplace_back("on the globe", lonlat_text(place, frame.crs));
  const float value = geom::sample_bilinear(field, frame.column(place.x), frame.row(place.y));
  const std::string unit = heights ? " m" : "";
  info.emplace_back(heights ? "height" : "value",
                    std::isfinite(value) ? io::short_number(static_cast<double>(value)) + unit : "unknown");
  if (heights) {
    const auto slope = static_cast<double>(cell_at(geom::slope_deg(field, {}), place));
    info.emplace_back("slope", std::isfinite(slope) ? tenths(slope) + " degrees" : "unknown");
  }
  if (!asked.labels.empty()) info.emplace_back("region", region_at(asked.labels, frame, place));
  return info;
}

}  // namespace seamount::recipe

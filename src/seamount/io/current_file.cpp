#include "seamount/io/current_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/placement.h"
#include "seamount/io/raster_files.h"
#include "seamount/io/reproject.h"
#include "seamount/io/way.h"
#include "seamount/model/same_size.h"

namespace seamount::io {
namespace {

constexpr const char* const kDrivers[] = {"GTiff", nullptr};

/// Which bands hold the components, and metres a second in their unit.
struct Bands {
  int east = 1, north = 2;
  double unit = 1.0;
  OGRSpatialReference system;  ///< of the file; empty: none
};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_one_of(const std::string& text, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return text == name; });
}

bool is_east(const std::string& name) {
  return name.find("east") != std::string::npos || is_one_of(name, {"u", "uo", "u10", "x", "vx"});
}
bool is_north(const std::string& name) {
  return name.find("north") != std::string::npos || is_one_of(name, {"v", "vo", "v10", "y", "vy"});
}

std::optional<double> metres_a_second(const std::string& unit) {
  if (is_one_of(unit, {"", "m/s", "m s-1", "m.s-1", "m s^-1", "ms-1", "metre/second", "meter/second"})) return 1.0;
  if (is_one_of(unit, {"cm/s", "cm s-1", "cm.s-1"})) return 0.01;
  if (is_one_of(unit, {"km/h", "km h-1"})) return 1.0 / 3.6;
  if (is_one_of(unit, {"kn", "kt", "knot", "knots"})) return 1852.0 / 3600.0;
  return std::nullopt;
}

Bands find_bands(const std::string& path, const RunContext& run) {
  const GdalCall call(path);
  const DatasetPtr dataset = open_dataset(call, path, GDAL_OF_RASTER, kDrivers, "a GeoTIFF file");
  const int count = dataset->GetRasterCount();
  if (count < 2)
    call.fail("has " + std::to_string(count) + (count == 1 ? " band" : " bands") +
              "; a current needs two, its east and its north components in m/s");
  Bands bands;
  std::optional<int> east, north;
  for (int b = 1; b <= count; ++b) {
    const std::string name = lower(dataset->GetRasterBand(b)->GetDescription());
    if (!east && is_east(name)) east = b;
    if (!north && is_north(name)) north = b;
  }
  if (east && north && *east != *north) {
    bands.east = *east;
    bands.north = *north;
  } else if (count > 2) {
    run.say(path + ": its bands are not called east and north; the first two of " + std::to_string(count) +
            " are taken");
  }
  const std::string unit = lower(dataset->GetRasterBand(bands.east)->GetUnitType());
  if (unit != lower(dataset->GetRasterBand(bands.north)->GetUnitType()))
    call.fail("its bands are in different units, '" + unit + "' and '" +
              dataset->GetRasterBand(bands.north)->GetUnitType() + "'");
  const std::optional<double> known = metres_a_second(unit);
  if (!known)
    call.fail("its bands are in '" + unit + "', which is no unit of speed that is known: m/s, cm/s, km/h, knots");
  bands.unit = *known;
  if (bands.unit != 1.0) run.say(path + ": speeds in " + unit + " are converted to m/s");
  if (const OGRSpatialReference* system = dataset->GetSpatialRef(); system != nullptr && system->IsLocal() == 0) {
    bands.system = *system;
    if (bands.system.IsCompound() != 0) bands.system.StripVertical();
    bands.system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  }
  return bands;
}

/// A cell that lacks one component lacks both.
void pair_voids(VectorField& current) {
  for (size_t i = 0; i < current.x.size(); ++i) {
    float &u = current.x.cells()[i], &v = current.y.cells()[i];
    if (std::isnan(u) || std::isnan(v)) u = v = std::numeric_limits<float>::quiet_NaN();
  }
}

/// Turns vectors along the axes of another system, whose north is looked up at every 32nd cell, to the current's own.
void turn(VectorField& current, const OGRSpatialReference& from) {
  constexpr int kStep = 32;
  const GridFrame frame = current.frame();
  const std::unique_ptr<OGRSpatialReference> to = parse_crs(frame.crs);
  if (!to || from.IsEmpty() || from.IsSame(to.get()) != 0) return;
  const int columns = (frame.width - 1) / kStep + 2, rows = (frame.height - 1) / kStep + 2;
  std::vector<Vec2> places, ahead;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      places.push_back({frame.x(std::min(i * kStep, frame.width - 1)), frame.y(std::min(j * kStep, frame.height - 1))});
  ahead = places;
  Way(*to, from).move(ahead);
  const double step = from.IsGeographic() != 0 ? 1e-4 : 10.0;  // in the other system's units, towards its north
  for (Vec2& p : ahead) p.y += step;
  Way(from, *to).move(ahead);
  std::vector<double> sine(places.size()), cosine(places.size());
  for (size_t k = 0; k < places.size(); ++k) {
    const Vec2 north = ahead[k] - places[k];
    const double length = std::hypot(north.x, north.y);
    sine[k] = length > 0.0 ? -north.x / length : 0.0;  // of the angle, counter-clockwise, from our north to theirs
    cosine[k] = length > 0.0 ? north.y / length : 1.0;
  }
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const int i = x / kStep, j = y / kStep;
      const double s = static_cast<double>(x - i * kStep) / kStep, t = static_cast<double>(y - j * kStep) / kStep;
      const auto at = [&](const std::vector<double>& v) {
        const size_t k = static_cast<size_t>(j) * static_cast<size_t>(columns) + static_cast<size_t>(i);
        const size_t below = k + static_cast<size_t>(columns);
        return (1 - t) * ((1 - s) * v[k] + s * v[k + 1]) + t * ((1 - s) * v[below] + s * v[below + 1]);
      };
      const double a = at(sine), c = at(cosine), u = current.x(x, y), v = current.y(x, y);
      current.x(x, y) = static_cast<float>(c * u - a * v);
      current.y(x, y) = static_cast<float>(a * u + c * v);
    }
  }
}

}  // namespace

VectorField read_current(const std::string& path, const ReadOptions& options) {
  const std::string extension = lower(extension_of(path));
  if (extension != ".tif" && extension != ".tiff")
    throw IoError(path, "a current is read from a GeoTIFF of two bands (.tif)");
  const Bands bands = find_bands(path, options.run);
  ReadOptions one = options;
  one.run = options.run.part(0.0, 0.5);
  one.band = bands.east;
  VectorField current;
  current.x = read_field(path, one);
  one.band = bands.north;
  one.run = options.run.part(0.5, 1.0);
  one.run.note = nullptr;  // what is taken for granted is the same for both
  current.y = read_field(path, one);
  check_same_size("north components", current.y.frame(), current.x.frame(), "east components");
  if (bands.unit != 1.0)
    for (ScalarField* part : {&current.x, &current.y})
      for (float& v : part->cells()) v = static_cast<float>(bands.unit * v);
  pair_voids(current);
  if (options.crs.empty()) turn(current, bands.system);
  return current;
}

void write_current(const VectorField& current, const std::string& path, const WriteOptions& options) {
  if (lower(extension_of(path)) != ".tif") throw IoError(path, "a current is written to .tif");
  VectorField paired = current;
  pair_voids(paired);
  write_geotiff_current(paired, path, options);
}

VectorField on_cells(const VectorField& current, const GridFrame& frame, const RunContext& run) {
  VectorField moved{on_cells(current.x, frame, run.part(0.0, 0.5)), on_cells(current.y, frame, run.part(0.5, 1.0))};
  pair_voids(moved);
  if (current.frame().crs != frame.crs)
    if (const auto from = parse_crs(current.frame().crs)) turn(moved, *from);
  return moved;
}

VectorField in_system(const VectorField& current, const std::string& crs, const RunContext& run) {
  if (current.frame().crs == crs) return current;
  VectorField moved{in_system(current.x, crs, run.part(0.0, 0.5)), in_system(current.y, crs, run.part(0.5, 1.0))};
  pair_voids(moved);
  if (const auto from = parse_crs(current.frame().crs)) turn(moved, *from);
  return moved;
}

}  // namespace seamount::io

// In which system a raster lies, and what is said of it.
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {

bool must_be_degrees(const Placement& p, int columns, int rows, double relief, bool heights) {
  const double width = columns * p.cell_x, height = rows * p.cell_y;
  const bool on_globe = std::abs(p.west) <= 361 && p.west + width <= 541 && p.north <= 91 && p.north - height >= -91;
  if (!p.system.IsEmpty() || !on_globe || p.cell_x >= 1) return false;
  constexpr double kSurelyDegrees = 0.05;
  constexpr double kSteeperThanAnything = 5.0;  // relief over extent; a cliff is 1, degrees give 10 and more
  if (!heights || !(relief > 0)) return p.cell_x < kSurelyDegrees;
  return relief > kSteeperThanAnything * std::max(width, height);
}

bool must_be_degrees(const Placement& p, const Grid<float>& values, bool heights) {
  if (!p.system.IsEmpty()) return false;
  RasterInfo info;
  count_values(values, info);
  return must_be_degrees(p, values.width(), values.height(), info.max - info.min, heights);
}

void choose_system(Stored& stored, const std::string& name, const ReadOptions& options, Meaning meaning) {
  if (!options.crs.empty()) {
    stored.placement->system = OGRSpatialReference();
    if (options.crs != "local") stored.placement->system = *parse_crs(options.crs);
    stored.crs = options.crs == "local" ? "" : crs_text(&stored.placement->system);
  } else if (!stored.local && must_be_degrees(*stored.placement, stored.values, meaning == Meaning::heights)) {
    stored.placement->system = lonlat_system();
    say_degrees(name, options.run);
  }
}

void say_degrees(const std::string& name, const RunContext& run) {
  run.say(name +
          ": says nothing of its coordinate system; its numbers can only be degrees and are taken as longitude and "
          "latitude (\"crs\" states another; \"local\": metres)");
}

void say_own_cells(const std::string& name, double own_m, double told_m, const RunContext& run) {
  run.say(name + ": states its own cells, of " + format_number(own_m) + " m; cell_m = " + format_number(told_m) +
          " is ignored");
}

void say_voids(int64_t unknown, int64_t all, const std::string& name, const RunContext& run) {
  if (unknown == 0) return;
  if (unknown == all) throw IoError(name, "none of its " + std::to_string(all) + " cells has a value");
  run.say(name + ": " + std::to_string(unknown) + " of " + std::to_string(all) + " cells have no value");
}

}  // namespace seamount::io

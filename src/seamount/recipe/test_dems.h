// Ground for tests of what terrain does: real elevation models and, always there, made ranges.
//
// The real ones are looked for in the folder $SEAMOUNT_DEM_DIR, else in ../shared/data/dem beside the checkout. They
// are not part of the repository; a test without them says so and is skipped.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/io/raster.h"
#include "seamount/ops/erosion/run.h"
#include "seamount/ops/terrain/noise.h"

#ifndef SEAMOUNT_SOURCE_DIR  // test programs are told; the header compiles without
#define SEAMOUNT_SOURCE_DIR "."
#endif

namespace seamount::recipe {

/// The path of `name`.tif, if it is there.
inline std::optional<std::string> find_dem(const std::string& name) {
  namespace fs = std::filesystem;
  const char* folder = std::getenv("SEAMOUNT_DEM_DIR");
  const fs::path path =
      (folder != nullptr ? fs::path(folder) : fs::path(SEAMOUNT_SOURCE_DIR) / "../shared/data/dem") / (name + ".tif");
  std::error_code error;
  return fs::exists(path, error) ? std::optional<std::string>(path.string()) : std::nullopt;
}

/// A range worn by some hundred thousand years of rain, as a radar of 90 m cells sees it: without what is finer than
/// two.
inline HeightField made_range(int cells, uint64_t seed) {
  const HeightField noise =
      terrain::noise({.kind = terrain::NoiseKind::smooth, .height_m = 1400, .wavelength_m = 14000, .base_m = 1500},
                     GridFrame::centred(cells, cells, 90), Seed{seed}, {});
  HeightField worn =
      erosion::run({noise, {}, {}}, {}, {.years = 200000, .slopes = {.creep_m2_yr = 0.03}}, Seed{seed}, {}).terrain;
  geom::gaussian_blur(worn, 150, {});
  return worn;
}

/// The middle of a real elevation model, or of "made_1", "made_2", ... a range of that seed; nothing without the file.
inline std::optional<HeightField> find_ground(const std::string& name, int cells) {
  static std::map<std::pair<std::string, int>, HeightField> made;
  if (name.starts_with("made_")) {
    const auto key = std::pair(name, cells);
    if (!made.contains(key)) made[key] = made_range(cells, std::stoull(name.substr(5)));
    return made[key];
  }
  const std::optional<std::string> path = find_dem(name);
  if (!path) return std::nullopt;
  io::ReadOptions options;
  HeightField whole = io::read_heights(*path, options);
  geom::fill_voids(whole, {});
  const GridFrame& from = whole.frame();
  GridFrame frame = GridFrame::centred(cells, cells, from.cell_m);
  frame.west_m += 0.5 * (from.west_m + from.east_m());
  frame.north_m += 0.5 * (from.south_m() + from.north_m);
  return geom::resample(whole, frame, {});
}

}  // namespace seamount::recipe

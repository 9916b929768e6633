// What the kinds of rasters have in common.
#pragma once

#include <optional>
#include <string>

#include "seamount/geom/grid/voids.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/io/raster.h"
#include "seamount/io/reproject.h"
#include "seamount/recipe/kind.h"

namespace seamount::recipe {

inline io::ReadOptions read_options(const FileCall& call) {
  io::ReadOptions options;
  options.into = call.frame.crs;
  options.cover = call.joins;
  if (call.joins && !call.frame.crs.empty()) options.lattice = call.frame;
  options.run = call.run;
  return options;
}

template <class T>
Grid<T> bring_raster(const Grid<T>& raster, const Destination& to) {
  return to.cells ? io::on_cells(raster, to.frame, to.run) : io::in_system(raster, to.frame.crs, to.run);
}

inline std::optional<Grid<float>> fill_raster(const Grid<float>& raster, const std::string& name,
                                              const RunContext& run) {
  const int64_t voids = geom::count_voids(raster, run);
  if (voids == 0) return std::nullopt;
  Grid<float> filled = raster;
  geom::fill_voids(filled, run);
  run.say(name + ": " + std::to_string(voids) + " of " + std::to_string(raster.size()) +
          " cells have no value and are filled from the rims of their holes");
  return filled;
}

}  // namespace seamount::recipe

// Currents from and to files, and elsewhere.
//
// GeoTIFF of two bands: east and north components in m/s along the file's columns and rows. Bands are known by their
// descriptions (east, north; u, v; uo, vo; u10, v10; x, y), else the first two are taken, which is said. Units: m/s,
// cm/s, km/h, knots, as the bands say; without one m/s. A cell that lacks one component has no current that is known
// (NaN).
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/io/raster.h"
#include "seamount/io/read_options.h"
#include "seamount/model/vector_field.h"

namespace seamount::io {

/// Throws IoError{path} as read_field(), and for a raster with fewer than two bands or in another unit. Of a raster in
/// degrees, which comes into a system in metres, vectors are turned from the meridians to that system's axes.
VectorField read_current(const std::string& path, const ReadOptions& options = {});

/// .tif: float32, bands described "eastward current" and "northward current", unit m/s. Unknown cells are no-data
/// (nan).
void write_current(const VectorField& current, const std::string& path, const WriteOptions& options = {});

/// As in_system() and on_cells() of rasters (reproject.h), components one by one. Where the systems' axes are turned
/// against each other, vectors turn with them: each points to the same place on the ground as before, at its speed.
VectorField in_system(const VectorField& current, const std::string& crs, const RunContext& run);
VectorField on_cells(const VectorField& current, const GridFrame& frame, const RunContext& run);

}  // namespace seamount::io

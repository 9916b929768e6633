// Rasters in degrees, feet or oblong cells to square cells in metres. Not part of the public interface.
#pragma once

#include <array>
#include <string>

#include "seamount/io/gdal_call.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// Where a stored raster lies: north-up affine placement in its own system.
struct Placement {
  double west = 0, north = 0;     ///< outer corner of the first cell
  double cell_x = 1, cell_y = 1;  ///< both > 0, in units of the system
  OGRSpatialReference system;     ///< empty: metres without a system
};

/// The raster on square cells in metres, covering the largest upright rectangle that lies inside it. Metric systems are
/// kept, others become a local transverse Mercator; the cell keeps the number of cells about the same. Bilinear; a
/// target is NaN where less than half of the weight has a value. Throws IoError through `call` for a raster more than
/// 20 degrees of longitude across or more than max_cells.
Grid<float> warp_to_metres(const Grid<float>& stored, const Placement& placement, const GdalCall& call,
                           int64_t max_cells);

/// True if the system's unit is the metre (or there is no system).
bool is_metric(const OGRSpatialReference& system);

}  // namespace seamount::io

// Rasters in degrees, feet, oblong cells or metres that are none to square cells in metres. Not part of the public
// interface.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/io/placement.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// How a warped raster is laid out.
struct Layout {
  bool cover = false;                  ///< all of the raster, NaN beyond; else the largest rectangle inside it
  const GridFrame* lattice = nullptr;  ///< whose cells are taken if theirs are about as large; null: none
  int64_t max_cells = 0;
};

/// What must be done with a raster so that its cells are squares of metres.
struct Settlement {
  bool as_it_is = false;  ///< nothing
  std::string crs;        ///< the system in metres; empty: none
  std::string note;       ///< what the user should know; empty: nothing
};

/// Metric systems are kept, unless lengths in them are off by more than 1 % of the true ones (Web Mercator far from the
/// equator); those and all others become a local transverse Mercator. Throws IoError through `call` for a raster more
/// than 20 degrees of longitude across that cannot be kept.
Settlement settle(const Placement& placement, int width, int height, const GdalCall& call);

/// Where warp_to_metres() lays a raster, and whether it is turned against north so far that all of it is covered though
/// the layout did not ask for it.
GridFrame warped_frame(const Placement& placement, int width, int height, const Settlement& settlement,
                       const Layout& layout, const GdalCall& call, bool& turned);

struct Warped {
  Grid<float> raster;
  bool turned = false;  ///< against north, so far that all of it is covered though the layout did not ask for it
};

/// The raster on square cells in metres, on the largest upright rectangle that lies inside it or, as the layout says
/// and where it comes out turned so far that this would lose much, all of it with NaN beyond; the cell keeps the number
/// of cells about the same. Bilinear; a target is NaN where less than half of the weight has a value. Throws IoError
/// through `call` for more than max_cells; Cancelled. Serial, about 100 ns per cell.
Warped warp_to_metres(const Grid<float>& stored, const Placement& placement, const Settlement& settlement,
                      const Layout& layout, const GdalCall& call, const RunContext& run);

/// True if the system's unit is the metre (or there is no system).
bool is_metric(const OGRSpatialReference& system);

}  // namespace seamount::io

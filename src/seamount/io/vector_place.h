// Shapes from the coordinates of their file to metres on the ground. Not part of the public interface.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/io/gdal_call.h"
#include "seamount/model/areas.h"

namespace seamount::io {

/// What is known about a file's coordinates.
struct FilePlace {
  const OGRSpatialReference* system = nullptr;  ///< as the file says; null: it says none
  bool assumed_lonlat = false;                  ///< the format means longitude and latitude where the file says nothing
  std::string stated;                           ///< VectorOptions::crs
};

/// Brings a drawing to metres as read_drawing() says, sets its crs, and gives the rectangle around its lines in the
/// file's coordinates as a ring in the drawing's, counter-clockwise (empty without lines). Throws IoError through
/// `call`.
Ring bring_to_metres(Drawing& drawing, const FilePlace& place, const GdalCall& call, const RunContext& run);

/// Whether a system says nothing about a place on the Earth: none, an engineering one, GeoPackage's undefined ones.
bool is_undefined(const OGRSpatialReference* system);

}  // namespace seamount::io

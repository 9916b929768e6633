// Opening a vector file through GDAL. Not part of the public interface.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/io/gdal_call.h"

namespace seamount::io {

/// Throws IoError unless the extension is one that is read: .geojson, .json, .gpkg, .shp, .svg.
void check_vector_extension(const std::string& path);

/// Opens GeoJSON, GeoPackage or Shapefile (svg_read.h reads SVG); of a GeoPackage only what its table of contents
/// names, after a look at its schema (geopackage.h). Queries of it stop when `run`, which must outlive the dataset, is
/// cancelled. Throws IoError.
DatasetPtr open_vector(const std::string& place, const GdalCall& call, const RunContext& run);

}  // namespace seamount::io

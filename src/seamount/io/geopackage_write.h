// A new GeoPackage, written whole or not at all. Not part of the public interface.
#pragma once

#include <functional>
#include <string>

#include "seamount/io/gdal_call.h"

namespace seamount::io {

/// What GeoPackage calls a plane without a place on the Earth.
inline constexpr const char* kLocalMetres =
    "ENGCRS[\"Undefined Cartesian "
    "SRS\",EDATUM[\"\"],CS[Cartesian,2],AXIS[\"(E)\",east,ORDER[1],LENGTHUNIT[\"metre\",1]],"
    "AXIS[\"(N)\",north,ORDER[2],LENGTHUNIT[\"metre\",1]]]";

using FillGeopackage = std::function<void(GDALDataset& dataset, OGRSpatialReference& system, const GdalCall& call)>;

/// Makes the file `path` of the layers that `fill` adds in one transaction, in the system `crs` (empty: local metres).
/// The same content gives the same bytes. Throws IoError{path}, InvalidArgument{"crs"}.
void write_new_geopackage(const std::string& path, const std::string& crs, const FillGeopackage& fill);

}  // namespace seamount::io

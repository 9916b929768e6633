// Areas, lines and places from and to GIS files. In: GeoJSON, GeoPackage, Shapefile. Out: GeoJSON, GeoPackage, SVG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"

namespace seamount::io {

struct VectorOptions {
  std::string feature;  ///< only the features of this name (any letter case); empty: all
  std::string layer;    ///< of a file with several; empty: all of write_drawing()'s own ("areas", "lines", "points"),
                        ///< else the first with areas or lines, else with points
};

/// Areas and lines in metres. Longitude and latitude become a local transverse Mercator (projection.h) centred on what
/// was selected; a metric system is kept; a file without a system is taken as metres. Names come from an attribute
/// called "name" (any case), else the first text attribute; values of lines and points from "value", "elevation",
/// "elev", "height" or "height_m", else a shape's own z; other numbers become attributes.
/// Shapes across the 180th meridian are joined. Self-intersections are the caller's to find.
/// Throws IoError{path}: missing, truncated, nothing drawn, unknown feature (with the nearest name), more than 20
/// degrees of longitude at once, a GeoPackage whose schema cannot be trusted (geopackage.h); Cancelled.
Drawing read_drawing(const std::string& path, const VectorOptions& options = {}, const RunContext& run = {});
/// The same from the bytes of a GeoJSON file; `name` stands in messages.
Drawing read_geojson(std::span<const uint8_t> bytes, const std::string& name, const VectorOptions& options = {});

/// read_drawing() that must find at least one area.
Drawing read_areas(const std::string& path, const VectorOptions& options = {}, const RunContext& run = {});

/// Names of the features, for choosing one.
std::vector<std::string> feature_names(const std::string& path, const RunContext& run = {});

/// By extension: .geojson/.json (longitude and latitude as RFC 7946 wants where a CRS is known, else metres and a
/// "crs" member that says so), .gpkg (layers "areas", "lines" and "points" in the drawing's CRS), .svg (one unit a
/// metre, north up). Areas carry "name", lines and points "value" (or "height_m" and z, see Drawing), all of
/// them their attributes. The frame goes along: as metadata "seamount_frame", as a member "seamount", as the view.
void write_drawing(const Drawing& drawing, const std::string& path);

}  // namespace seamount::io

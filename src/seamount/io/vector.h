// Areas, lines and places from and to GIS files. In: GeoJSON, GeoPackage, Shapefile, SVG. Out: GeoJSON, GeoPackage,
// SVG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"

namespace seamount::io {

/// What a caller makes of a file, by which the layer is chosen that fits.
enum class WantedShapes { any, areas, lines };

struct VectorOptions {
  std::string feature;  ///< only the features of this name (any letter case); empty: all
  std::string layer;    ///< of a file with several; empty: all of write_drawing()'s own ("areas", "lines", "points"),
                        ///< else the first that is not empty and fits what is wanted, which is said
  std::string height_field;  ///< the field with the values of lines and points; empty: one whose name means a height
  std::string crs;           ///< the file's system, for one that says none or a wrong one; "local": metres on no map
  WantedShapes wanted = WantedShapes::any;  ///< areas: layers of areas before those of lines; points are passed over
  bool heights = false;                     ///< every line must have a height
};

/// Areas and lines in metres that are metres on the ground. A metric system is kept where its distances are right
/// within 1 % at the shapes' place; degrees, feet and stretched systems (Web Mercator) become a local transverse
/// Mercator (projection.h) centred on what was selected. Undefined systems are local metres. A file that says nothing
/// is in degrees where its numbers can be (at most 360 and 90, within 20), else in metres; so is GeoJSON without a
/// "crs" whose numbers cannot be degrees. Such guesses are said.
///
/// Names come from an attribute called "name" (any case), else the first text attribute. Values of lines and points
/// come from `height_field` or a field named like a height (vector_heights.h), in metres, else from a shape's own z;
/// areas carry it as the attribute "height_m". Other numbers become attributes. Shapes across the 180th meridian are
/// joined. Self-intersections are the caller's to find. Throws IoError{path}: missing, truncated, nothing drawn,
/// unknown layer, feature or field (with the nearest name), a line without a height where they are required (with its
/// place and the fields there are), more than 20 degrees of longitude at once, a GeoPackage whose schema cannot be
/// trusted (geopackage.h); Cancelled.
Drawing read_drawing(const std::string& path, const VectorOptions& options = {}, const RunContext& run = {});
/// The same from the bytes of a GeoJSON file; `name` stands in messages.
Drawing read_geojson(std::span<const uint8_t> bytes, const std::string& name, const VectorOptions& options = {},
                     const RunContext& run = {});
/// The same from the bytes of an SVG file (svg_read.h).
Drawing read_svg(std::span<const uint8_t> bytes, const std::string& name, const VectorOptions& options = {},
                 const RunContext& run = {});

/// Lines with what the sheet was that they may have been cut from.
struct SheetLines {
  Drawing drawing;
  Ring sheet;  ///< the rectangle around the lines in the file's own coordinates, in the drawing's; empty: no lines
};

/// read_drawing() for contours: options.heights, and layers of lines before all others.
SheetLines read_contour_lines(const std::string& path, VectorOptions options = {}, const RunContext& run = {});

/// read_drawing() that must find at least one area or line; layers of areas before all others.
Drawing read_areas(const std::string& path, VectorOptions options = {}, const RunContext& run = {});

/// By extension: .geojson/.json (longitude and latitude as RFC 7946 wants where a CRS is known, else metres and a
/// "crs" member that says so), .gpkg (layers "areas", "lines" and "points" in the drawing's CRS), .svg (one unit a
/// metre, north up). Areas carry "name", lines and points "value" (or "height_m" and z, see Drawing), all of
/// them their attributes. The frame goes along: as metadata "seamount_frame", as a member "seamount", as the view.
void write_drawing(const Drawing& drawing, const std::string& path);

}  // namespace seamount::io

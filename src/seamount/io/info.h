// What a file is, for people: (what, value) lines in reading order, such as {"size", "2017 x 2017"}, {"heights",
// "-812.4 m to 1903.2 m"}, and from a side-car the numbers to type into an engine.
//
// Each function says nothing of a file whose name is not of its sort, and throws IoError for one that is and cannot be
// read.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace seamount::io {

using FileInfo = std::vector<std::pair<std::string, std::string>>;

/// Rasters of heights, scalars and labels (with the share of each region): readable_raster_extensions(), but pictures
/// in colour.
std::optional<FileInfo> describe_raster(const std::string& path);

/// Pictures: JPEG, and PNG with more than grey and alpha; of those in the colours of regions the share of each.
std::optional<FileInfo> describe_picture(const std::string& path);

/// Areas, lines and points: .geojson, .json, .gpkg, .shp, .svg. Layer by layer how many of each, the coordinate system,
/// the extent in its units, the fields; of a single layer also the heights and the names of its features.
std::optional<FileInfo> describe_vector(const std::string& path);

/// Six significant digits, enough to read.
std::string short_number(double value);

}  // namespace seamount::io

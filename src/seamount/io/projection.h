// Coordinate reference systems as text: "EPSG:32604" where an authority's code is known, else WKT 2.
#pragma once

#include <string>
#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// A transverse Mercator on WGS 84, in metres, whose origin and place of true scale is the given one. Scale grows to
/// 1.0012 at 300 km east or west of it. The place is
/// rounded to a ten thousandth of a degree, the longitude any of its turns.
std::string local_crs(double longitude_deg, double latitude_deg);

/// Lengths in a system in metres may be off by so much of the true ones; beyond it data are brought to a local_crs().
inline constexpr double kMostLengthError = 0.01;

/// Places (metres) of a system to longitude, latitude in degrees on WGS 84. Throws InvalidArgument{"crs"} for text that
/// is not a system or a place outside of it.
std::vector<Vec2> to_lonlat(const std::vector<Vec2>& places, const std::string& crs);

/// The inverse.
std::vector<Vec2> from_lonlat(const std::vector<Vec2>& degrees, const std::string& crs);

/// The text of a system in metres as it is kept everywhere: "EPSG:32604", or WKT; empty for empty text. Throws
/// InvalidArgument{"crs"} for text that is no system, or one that is not in metres.
std::string metric_crs(const std::string& crs);

/// The largest error of lengths in a frame's system that are taken for metres, as a share; 0 without a system. Throws
/// InvalidArgument{"crs"}.
double length_error(const GridFrame& frame);

/// A name for people: "WGS 84 / UTM zone 4N".
std::string crs_name(const std::string& crs);

}  // namespace seamount::io

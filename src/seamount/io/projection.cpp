#include "seamount/io/projection.h"

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/warp.h"
#include "seamount/io/way.h"

namespace seamount::io {
namespace {

constexpr const char* kLonlat = "OGC:CRS84";  ///< WGS 84, longitude before latitude

}  // namespace

std::string local_crs(double longitude_deg, double latitude_deg) {
  const auto rounded = [](double degrees) { return std::round(degrees * 1e4) / 1e4; };
  longitude_deg = rounded(longitude_deg - 360 * std::round(longitude_deg / 360));
  latitude_deg = rounded(latitude_deg);
  const GdalCall call("crs");
  OGRSpatialReference system;
  const std::string name =
      "Local transverse Mercator at " + format_number(latitude_deg) + " N " + format_number(longitude_deg) + " E";
  system.SetProjCS(name.c_str());
  system.SetWellKnownGeogCS("WGS84");
  system.SetTM(latitude_deg, longitude_deg, 1.0, 0.0, 0.0);
  system.SetLinearUnits(SRS_UL_METER, 1.0);
  return crs_text(&system);
}

std::vector<Vec2> to_lonlat(const std::vector<Vec2>& places, const std::string& crs) {
  std::vector<Vec2> degrees = places;
  Way(crs, kLonlat).move(degrees);
  return degrees;
}

std::vector<Vec2> from_lonlat(const std::vector<Vec2>& degrees, const std::string& crs) {
  std::vector<Vec2> places = degrees;
  Way(kLonlat, crs).move(places);
  return places;
}

std::string metric_crs(const std::string& crs) {
  const GdalCall call("crs");
  const auto system = parse_crs(crs);
  if (!system) return {};
  if (!is_metric(*system))
    throw InvalidArgument("crs", "'" + crs.substr(0, 80) + "' is not in metres; a document is, such as in EPSG:32604");
  return crs_text(system.get());
}

double length_error(const GridFrame& frame) {
  const GdalCall call("crs");
  return scale_error(placement_of(frame), frame.width, frame.height);
}

std::string crs_name(const std::string& crs) {
  const GdalCall call("crs");
  const auto system = parse_crs(crs);
  const char* name = system ? system->GetName() : nullptr;
  return name != nullptr ? name : crs;
}

}  // namespace seamount::io

#include "seamount/io/projection.h"

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/warp.h"

namespace seamount::io {
namespace {

std::vector<Vec2> transform(const std::vector<Vec2>& places, const OGRSpatialReference& from,
                            const OGRSpatialReference& to) {
  const TransformPtr transform(OGRCreateCoordinateTransformation(&from, &to));
  if (!transform) throw InvalidArgument("crs", "no way between '" + crs_text(&from) + "' and longitude, latitude");
  std::vector<double> x(places.size()), y(places.size());
  for (size_t i = 0; i < places.size(); ++i) x[i] = places[i].x, y[i] = places[i].y;
  std::vector<int> good(places.size());
  transform->Transform(static_cast<int>(places.size()), x.data(), y.data(), nullptr, nullptr, good.data());
  std::vector<Vec2> result(places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    if (good[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i]))
      throw InvalidArgument("crs", "(" + format_number(places[i].x) + ", " + format_number(places[i].y) +
                                       ") is outside of the coordinate reference system");
    result[i] = {x[i], y[i]};
  }
  return result;
}

std::unique_ptr<OGRSpatialReference> required_crs(const std::string& crs) {
  if (crs.empty()) throw InvalidArgument("crs", "is not known");
  return parse_crs(crs);
}

}  // namespace

std::string local_crs(double longitude_deg, double latitude_deg) {
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
  const GdalCall call("crs");
  return transform(places, *required_crs(crs), lonlat_system());
}

std::vector<Vec2> from_lonlat(const std::vector<Vec2>& degrees, const std::string& crs) {
  const GdalCall call("crs");
  return transform(degrees, lonlat_system(), *required_crs(crs));
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

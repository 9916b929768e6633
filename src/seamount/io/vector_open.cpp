#include "seamount/io/vector_open.h"

#include <algorithm>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/geopackage.h"

namespace seamount::io {
namespace {

constexpr const char* const kDrivers[] = {"GeoJSON", "ESRI Shapefile", nullptr};
constexpr const char* const kGeoPackage[] = {"GPKG", nullptr};
constexpr const char* kWhat = "a GeoJSON, GeoPackage or Shapefile";

}  // namespace

void check_vector_extension(const std::string& path) {
  const std::vector<std::string> known = {".geojson", ".json", ".gpkg", ".shp", ".svg"};
  const std::string extension = extension_of(path);
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw IoError(path, "'" + extension + "' is not a vector format" + suggestion(extension, known));
}

DatasetPtr open_vector(const std::string& place, const GdalCall& call, const RunContext& run) {
  const bool geopackage = extension_of(place) == ".gpkg";
  if (geopackage) check_geopackage(place, run);
  constexpr const char* const kOptions[] = {"LIST_ALL_TABLES=NO", nullptr};
  DatasetPtr dataset = open_dataset(call, place, GDAL_OF_VECTOR, geopackage ? kGeoPackage : kDrivers, kWhat,
                                    geopackage ? kOptions : nullptr);
  watch_queries(*dataset, run);
  return dataset;
}

}  // namespace seamount::io

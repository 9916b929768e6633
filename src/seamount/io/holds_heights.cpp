#include "seamount/io/holds_heights.h"

#include <algorithm>
#include <array>

#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/raster.h"
#include "seamount/io/sidecar.h"

namespace seamount::io {
namespace {

bool tiff_holds_heights(const std::string& path) {
  const GdalCall call(path);
  constexpr const char* const kDrivers[] = {"GTiff", nullptr};
  const DatasetPtr file = open_dataset(call, path, GDAL_OF_RASTER, kDrivers, "a GeoTIFF");
  if (file->GetRasterCount() != 1) return false;
  if (file->GetMetadataItem("SEAMOUNT_CRS") != nullptr) return file->GetMetadataItem("VERTICAL_DATUM") != nullptr;
  std::array<double, 6> transform{};
  return file->GetRasterBand(1)->GetRasterDataType() != GDT_Byte && file->GetGeoTransform(transform.data()) == CE_None;
}

}  // namespace

bool holds_heights(const std::string& path) {
  const std::string extension = extension_of(path);
  const auto& known = readable_raster_extensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) return false;
  if (extension == ".tif" || extension == ".tiff") return tiff_holds_heights(path);
  if (extension == ".asc" || extension == ".hgt") return true;
  const auto sidecar = read_sidecar(path);
  return sidecar && sidecar->heights && !sidecar->for_painting;
}

}  // namespace seamount::io

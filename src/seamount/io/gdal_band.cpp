#include "seamount/io/gdal_band.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/vertical_unit.h"

namespace seamount::io {
namespace {

constexpr const char* const kDrivers[] = {"GTiff", "SRTMHGT", "AAIGrid", nullptr};
constexpr const char* kWhat = "a GeoTIFF, HGT or ASC file";

bool is_coloured(GDALDataset& dataset) {
  const int bands = dataset.GetRasterCount();
  GDALRasterBand& first = *dataset.GetRasterBand(1);
  if (first.GetColorInterpretation() == GCI_PaletteIndex) return true;
  return (bands == 3 || bands == 4) && first.GetRasterDataType() == GDT_Byte;
}

constexpr const char* kOurs = "SEAMOUNT_CRS";  ///< the metadata item that all our files have

}  // namespace

std::string type_name(GDALDataType type) {
  switch (type) {
    case GDT_Byte:
      return "uint8";
    case GDT_UInt16:
      return "uint16";
    case GDT_Int16:
      return "int16";
    case GDT_UInt32:
      return "uint32";
    case GDT_Int32:
      return "int32";
    case GDT_Float32:
      return "float32";
    case GDT_Float64:
      return "float64";
    default:
      return GDALGetDataTypeName(type);
  }
}

DatasetPtr open_raster(const GdalCall& call, const std::string& place) {
  try {
    return open_dataset(call, place, GDAL_OF_RASTER, kDrivers, kWhat);
  } catch (const IoError&) {
    if (extension_of(call.path()) != ".hgt") throw;
    throw IoError(call.path(),
                  "is no HGT file: those are named by their south-western corner, N46E008.hgt, and hold nothing but "
                  "3601 x 3601, 1801 x 3601 or 1201 x 1201 samples of 16 bits (25 934 402, 12 967 202 or 2 884 802 "
                  "bytes)");
  }
}

void check_blocks(GDALDataset& dataset, GDALRasterBand& band, const GdalCall& call) {
  constexpr double kAlwaysFine = 16e6, kMost = 4e9;  // bytes
  int block_x = 0, block_y = 0;
  band.GetBlockSize(&block_x, &block_y);
  const double cell_bytes = 1.0 * GDALGetDataTypeSizeBytes(band.GetRasterDataType()) * dataset.GetRasterCount();
  const double block = cell_bytes * block_x * block_y, all = cell_bytes * band.GetXSize() * band.GetYSize();
  if (block > std::min(kMost, std::max(kAlwaysFine, 2 * all)))
    call.fail("its blocks of " + std::to_string(block_x) + " x " + std::to_string(block_y) + " cells are too large");
}

GDALRasterBand& checked_band(GDALDataset& dataset, std::optional<int> wanted, bool heights, const GdalCall& call) {
  const int bands = dataset.GetRasterCount();
  if (bands < 1) call.fail("has no raster in it");
  const int band = wanted.value_or(1);
  if (band < 1 || band > bands)
    call.fail("has " + std::to_string(bands) + (bands == 1 ? " band" : " bands") + ", band " + std::to_string(band) +
              " was asked for");
  if (heights && !wanted && is_coloured(dataset))
    call.fail("holds colours, " + std::to_string(bands) + (bands == 1 ? " band with a palette" : " bands of 8 bits") +
              "; name the band that holds heights, or the coding of heights in colours: terrarium or mapbox");
  GDALRasterBand& found = *dataset.GetRasterBand(band);
  if (GDALDataTypeIsComplex(found.GetRasterDataType())) call.fail("holds complex numbers");
  check_blocks(dataset, found, call);
  return found;
}

std::optional<Placement> placement_of(GDALDataset& dataset, Flips& flips, const GdalCall& call) {
  double t[6];
  if (dataset.GetGeoTransform(t) != CE_None) return std::nullopt;
  for (const double number : t)
    if (!std::isfinite(number)) call.fail("its geotransform is not finite");
  const double cell = std::max(std::abs(t[1]), std::abs(t[5]));
  if (std::abs(t[2]) > 1e-9 * cell || std::abs(t[4]) > 1e-9 * cell)
    call.fail("is rotated; warp it north-up first, with gdalwarp say");
  if (t[1] == 0 || t[5] == 0) call.fail("its cell size " + format_number(t[1]) + " cannot be used");
  flips = {t[5] > 0, t[1] < 0};
  Placement placement;
  placement.west = flips.east_first ? t[0] + t[1] * dataset.GetRasterXSize() : t[0];
  placement.north = flips.south_up ? t[3] + t[5] * dataset.GetRasterYSize() : t[3];
  placement.cell_x = std::abs(t[1]);
  placement.cell_y = std::abs(t[5]);
  const OGRSpatialReference* system = dataset.GetSpatialRef();
  if (system != nullptr && system->IsLocal() == 0) placement.system = *system;
  if (placement.system.IsCompound() != 0) placement.system.StripVertical();
  placement.system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return placement;
}

double height_unit(GDALDataset& dataset, GDALRasterBand& band, const ReadOptions& options, const GdalCall& call) {
  if (!options.unit.empty()) {
    const auto told = metres_in_unit(options.unit);
    if (!told) throw InvalidArgument("unit", "'" + options.unit + "' is no unit of length that is known");
    return *told;
  }
  const char* vertical_name = nullptr;
  double vertical = 0;
  const OGRSpatialReference* system = dataset.GetSpatialRef();
  if (system != nullptr && system->IsCompound() != 0)
    vertical = system->GetTargetLinearUnits("VERT_CS", &vertical_name);
  const std::string spelled = band.GetUnitType();
  if (spelled.empty() && !(vertical > 0)) return 1.0;
  const std::optional<double> own = spelled.empty() ? vertical : metres_in_unit(spelled);
  if (!own)
    call.fail("its heights are in '" + spelled + "', which is no unit of length that is known; state it (\"unit\")");
  if (!spelled.empty() && vertical > 0 && std::abs(vertical / *own - 1) > 1e-7)
    options.run.say(call.path() + ": its band says heights in " + spelled + ", its coordinate system in " +
                    (vertical_name != nullptr ? vertical_name : "another unit") + "; the band counts");
  const std::string name = spelled.empty() && vertical_name != nullptr ? vertical_name : spelled;
  if (*own != 1.0) options.run.say(call.path() + ": heights in " + name + " are converted to metres");
  return *own;
}

bool is_ours(GDALDataset& dataset) { return dataset.GetMetadataItem(kOurs) != nullptr; }

bool is_local(GDALDataset& dataset) {
  const char* text = dataset.GetMetadataItem(kOurs);
  return text != nullptr && std::string_view(text) == "local";
}

std::string kept_crs(GDALDataset& dataset, const OGRSpatialReference& system) {
  constexpr size_t kLongest = 10'000;
  const char* text = dataset.GetMetadataItem(kOurs);
  if (text != nullptr && std::strlen(text) < kLongest) {
    try {
      const auto ours = parse_crs(text);
      if (ours && ours->IsSame(&system) != 0) return text;
    } catch (const InvalidArgument&) {
      // Not ours after all: the file's own system holds.
    }
  }
  const OGRSpatialReference known = identified(system);
  return crs_text(&known);
}

}  // namespace seamount::io

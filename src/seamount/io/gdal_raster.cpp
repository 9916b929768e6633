// GeoTIFF, HGT and ASC through GDAL: reading.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/raster_files.h"
#include "seamount/io/warp.h"

namespace seamount::io {
namespace {

constexpr const char* const kDrivers[] = {"GTiff", "SRTMHGT", "AAIGrid", nullptr};
constexpr const char* kWhat = "a GeoTIFF, HGT or ASC file";

std::string format_name(GDALDataset& dataset) {
  const std::string driver = dataset.GetDriverName();
  if (driver == "GTiff") return "GeoTIFF";
  return driver == "AAIGrid" ? "ASC" : "HGT";
}

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

/// GDAL reads whole blocks, whose declared size may have nothing to do with the raster's.
void check_blocks(GDALDataset& dataset, GDALRasterBand& band, const GdalCall& call) {
  constexpr double kAlwaysFine = 16e6, kMost = 4e9;  // bytes
  int block_x = 0, block_y = 0;
  band.GetBlockSize(&block_x, &block_y);
  const double cell_bytes = 1.0 * GDALGetDataTypeSizeBytes(band.GetRasterDataType()) * dataset.GetRasterCount();
  const double block = cell_bytes * block_x * block_y, all = cell_bytes * band.GetXSize() * band.GetYSize();
  if (block > std::min(kMost, std::max(kAlwaysFine, 2 * all)))
    call.fail("its blocks of " + std::to_string(block_x) + " x " + std::to_string(block_y) + " cells are too large");
}

GDALRasterBand& checked_band(GDALDataset& dataset, int band, const GdalCall& call) {
  const int bands = dataset.GetRasterCount();
  if (bands < 1) call.fail("has no raster in it");
  if (band < 1 || band > bands)
    call.fail("has " + std::to_string(bands) + (bands == 1 ? " band" : " bands") + ", band " + std::to_string(band) +
              " was asked for");
  GDALRasterBand& found = *dataset.GetRasterBand(band);
  if (GDALDataTypeIsComplex(found.GetRasterDataType())) call.fail("holds complex numbers");
  check_blocks(dataset, found, call);
  return found;
}

/// Cells per side and in all, before anything is allocated for them.
void check_size(GDALDataset& dataset, int64_t max_cells, const GdalCall& call) {
  const int64_t width = dataset.GetRasterXSize(), height = dataset.GetRasterYSize();
  if (width < 1 || height < 1) call.fail("is empty");
  if (width * height > max_cells)
    call.fail(std::to_string(width) + " x " + std::to_string(height) + " cells are more than the limit of " +
              std::to_string(max_cells));
}

/// Where the file says that it lies; nullopt: nowhere. `south_up` if its first row is the southern one.
std::optional<Placement> placement_of(GDALDataset& dataset, bool& south_up, const GdalCall& call) {
  double t[6];
  if (dataset.GetGeoTransform(t) != CE_None) return std::nullopt;
  for (const double number : t)
    if (!std::isfinite(number)) call.fail("its geotransform is not finite");
  const double cell = std::max(std::abs(t[1]), std::abs(t[5]));
  if (std::abs(t[2]) > 1e-9 * cell || std::abs(t[4]) > 1e-9 * cell)
    call.fail("is rotated; warp it north-up first, with gdalwarp say");
  if (!(t[1] > 0) || t[5] == 0) call.fail("its cell size " + format_number(t[1]) + " cannot be used");
  south_up = t[5] > 0;
  Placement placement;
  placement.west = t[0];
  placement.north = south_up ? t[3] + t[5] * dataset.GetRasterYSize() : t[3];
  placement.cell_x = t[1];
  placement.cell_y = std::abs(t[5]);
  if (const OGRSpatialReference* system = dataset.GetSpatialRef()) placement.system = *system;
  placement.system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  // An ASC file without .prj whose cells are thousandths is the usual form of elevation in degrees.
  const bool fits_globe = std::abs(t[0]) <= 361 && std::abs(placement.north) <= 91;
  if (placement.system.IsEmpty() && format_name(dataset) == "ASC" && cell < 0.05 && fits_globe)
    placement.system = lonlat_system();
  return placement;
}

/// Values as float, NaN where the band's mask (nodata, alpha, mask band) says that there is none.
Grid<float> read_band(GDALRasterBand& band, bool south_up, const GdalCall& call, const RunContext& run) {
  const int width = band.GetXSize(), height = band.GetYSize();
  const bool masked = (band.GetMaskFlags() & GMF_ALL_VALID) == 0;
  std::vector<uint8_t> mask(masked ? static_cast<size_t>(width) : 0);
  Grid<float> grid(GridFrame{width, height});
  for (int y = 0; y < height; ++y) {
    run.check_cancelled();
    if (y % 64 == 63) run.report(static_cast<double>(y) / height);
    const std::span<float> row = grid.row(south_up ? height - 1 - y : y);
    if (band.RasterIO(GF_Read, 0, y, width, 1, row.data(), width, 1, GDT_Float32, 0, 0, nullptr) != CE_None)
      call.fail("is truncated or damaged in row " + std::to_string(y));
    if (masked && band.GetMaskBand()->RasterIO(GF_Read, 0, y, width, 1, mask.data(), width, 1, GDT_Byte, 0, 0,
                                               nullptr) != CE_None)
      call.fail("its mask is damaged in row " + std::to_string(y));
    for (size_t x = 0; x < mask.size(); ++x)
      if (mask[x] == 0) row[x] = std::nanf("");
  }
  for (float& z : grid.cells())
    if (!std::isfinite(z)) z = std::nanf("");
  return grid;
}

/// Metres in one unit of a band.
double unit_metres(const std::string& unit) {
  if (unit == "ft" || unit == "foot" || unit == "feet") return 0.3048;
  if (unit == "US survey foot" || unit == "us-ft" || unit == "sfoot") return 1200.0 / 3937.0;
  if (unit == "km") return 1000.0;
  if (unit == "cm") return 0.01;
  return 1.0;
}

/// The band's own scale and offset, and its unit if these are heights.
void apply_scale(Grid<float>& grid, GDALRasterBand& band, bool heights) {
  const double unit = heights ? unit_metres(band.GetUnitType()) : 1.0;
  const double scale = band.GetScale() * unit, offset = band.GetOffset() * unit;
  if (scale == 1.0 && offset == 0.0) return;
  for (float& z : grid.cells()) z = static_cast<float>(z * scale + offset);
}

/// Our own text of the system, if it still says what the file's system says.
std::string kept_crs(GDALDataset& dataset, const OGRSpatialReference& system) {
  constexpr size_t kLongest = 10'000;
  const char* text = dataset.GetMetadataItem("SEAMOUNT_CRS");
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

}  // namespace

Stored read_gdal(const std::string& place, const std::string& name, const ReadOptions& options, bool heights) {
  GdalCall call(name);
  call.hide(place);
  const DatasetPtr dataset = open_dataset(call, place, GDAL_OF_RASTER, kDrivers, kWhat);
  check_size(*dataset, options.max_cells, call);
  GDALRasterBand& band = checked_band(*dataset, options.band, call);
  bool south_up = false;
  std::optional<Placement> placement = placement_of(*dataset, south_up, call);
  const GDALDataType type = band.GetRasterDataType();
  Stored stored{read_band(band, south_up, call, options.run.part(0.0, 0.5)), false, 0.0, format_name(*dataset),
                type_name(type)};
  const bool no_unit = std::strlen(band.GetUnitType()) == 0 && band.GetScale() == 1.0;
  if ((type == GDT_Byte || type == GDT_UInt16) && no_unit) stored.code_max = type == GDT_Byte ? 255 : 65535;
  apply_scale(stored.values, band, heights);
  if (!placement) return stored;
  stored.georeferenced = true;
  const bool square = std::abs(placement->cell_x - placement->cell_y) <= 1e-9 * placement->cell_x;
  if (is_metric(placement->system) && square) {
    stored.values.set_frame({stored.values.width(), stored.values.height(), placement->cell_x, placement->west,
                             placement->north, kept_crs(*dataset, placement->system)});
  } else {
    stored.values = warp_to_metres(stored.values, *placement, call, options.max_cells);
  }
  return stored;
}

RasterInfo gdal_info(const std::string& path) {
  GdalCall call(path);
  const DatasetPtr dataset = open_dataset(call, path, GDAL_OF_RASTER, kDrivers, kWhat);
  check_size(*dataset, ReadOptions{}.max_cells, call);
  GDALRasterBand& band = checked_band(*dataset, 1, call);
  RasterInfo info;
  info.width = dataset->GetRasterXSize();
  info.height = dataset->GetRasterYSize();
  info.bands = dataset->GetRasterCount();
  info.format = format_name(*dataset);
  info.type = type_name(band.GetRasterDataType());
  bool south_up = false;
  if (const auto placement = placement_of(*dataset, south_up, call)) {
    info.cell_x = placement->cell_x;
    info.cell_y = placement->cell_y;
    info.geographic = !placement->system.IsEmpty() && placement->system.IsGeographic() != 0;
    info.crs = kept_crs(*dataset, placement->system);
  }
  int has_nodata = 0;
  const double nodata = band.GetNoDataValue(&has_nodata);
  if (has_nodata != 0) info.nodata = nodata;
  Grid<float> values = read_band(band, south_up, call, {});
  apply_scale(values, band, true);
  count_values(values, info);
  return info;
}

}  // namespace seamount::io

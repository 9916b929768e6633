// GeoTIFF, HGT and ASC through GDAL: reading.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/elevation_coding.h"
#include "seamount/io/raster_files.h"
#include "seamount/io/vertical_unit.h"
#include "seamount/io/void_codes.h"

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

/// Opens a raster. What HGT files must be called and how long they are is known by few.
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

bool is_coloured(GDALDataset& dataset) {
  const int bands = dataset.GetRasterCount();
  GDALRasterBand& first = *dataset.GetRasterBand(1);
  if (first.GetColorInterpretation() == GCI_PaletteIndex) return true;
  return (bands == 3 || bands == 4) && first.GetRasterDataType() == GDT_Byte;
}

/// The band that is asked for, or the first. Heights are not looked for in a picture unless its band is named.
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

/// Cells per side and in all, before anything is allocated for them.
void check_size(GDALDataset& dataset, int64_t max_cells, const GdalCall& call) {
  const int64_t width = dataset.GetRasterXSize(), height = dataset.GetRasterYSize();
  if (width < 1 || height < 1) call.fail("is empty");
  if (width * height > max_cells)
    call.fail(std::to_string(width) + " x " + std::to_string(height) + " cells are more than the limit of " +
              std::to_string(max_cells));
}

/// Which way the rows and columns of a file run, where it is not from north to south and from west to east.
struct Flips {
  bool south_up = false;
  bool east_first = false;
};

/// Where the file says that it lies; nullopt: nowhere.
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

/// Values as float, NaN where the band's mask (nodata, alpha, mask band) says that there is none.
Grid<float> read_band(GDALRasterBand& band, Flips flips, const GdalCall& call, const RunContext& run) {
  const int width = band.GetXSize(), height = band.GetYSize();
  const bool masked = (band.GetMaskFlags() & GMF_ALL_VALID) == 0;
  std::vector<uint8_t> mask(masked ? static_cast<size_t>(width) : 0);
  Grid<float> grid(GridFrame{width, height});
  for (int y = 0; y < height; ++y) {
    run.check_cancelled();
    if (y % 64 == 63) run.report(static_cast<double>(y) / height);
    const std::span<float> row = grid.row(flips.south_up ? height - 1 - y : y);
    if (band.RasterIO(GF_Read, 0, y, width, 1, row.data(), width, 1, GDT_Float32, 0, 0, nullptr) != CE_None)
      call.fail("is truncated or damaged in row " + std::to_string(y));
    if (masked && band.GetMaskBand()->RasterIO(GF_Read, 0, y, width, 1, mask.data(), width, 1, GDT_Byte, 0, 0,
                                               nullptr) != CE_None)
      call.fail("its mask is damaged in row " + std::to_string(y));
    for (size_t x = 0; x < mask.size(); ++x)
      if (mask[x] == 0) row[x] = std::nanf("");
    if (flips.east_first) std::reverse(row.begin(), row.end());
  }
  return grid;
}

/// Metres in one unit of a band's heights: as told, else as the band says, else as the file's vertical system does.
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

/// The band's own scale and offset, and its unit.
void apply_scale(Grid<float>& grid, GDALRasterBand& band, double unit) {
  const double scale = band.GetScale() * unit, offset = band.GetOffset() * unit;
  if (scale == 1.0 && offset == 0.0) return;
  for (float& z : grid.cells()) z = static_cast<float>(z * scale + offset);
}

/// Three bands of colours that code heights.
Grid<float> read_coded(GDALDataset& dataset, ElevationCoding coding, Flips flips, const GdalCall& call,
                       const RunContext& run) {
  const int bands = dataset.GetRasterCount();
  if (bands < 3) call.fail("has " + std::to_string(bands) + " bands; heights coded in colours need three");
  for (int b = 1; b <= 3; ++b) check_blocks(dataset, *dataset.GetRasterBand(b), call);
  Grid<float> red = read_band(*dataset.GetRasterBand(1), flips, call, run.part(0.0, 0.3));
  const Grid<float> green = read_band(*dataset.GetRasterBand(2), flips, call, run.part(0.3, 0.6));
  const Grid<float> blue = read_band(*dataset.GetRasterBand(3), flips, call, run.part(0.6, 1.0));
  for (size_t i = 0; i < red.size(); ++i)
    red.cells()[i] = coded_height(coding, red.cells()[i], green.cells()[i], blue.cells()[i]);
  return red;
}

constexpr const char* kOurs = "SEAMOUNT_CRS";  ///< the metadata item that all our files have

bool is_ours(GDALDataset& dataset) { return dataset.GetMetadataItem(kOurs) != nullptr; }

bool is_local(GDALDataset& dataset) {
  const char* text = dataset.GetMetadataItem(kOurs);
  return text != nullptr && std::string_view(text) == "local";
}

/// Our own text of the system, if it still says what the file's system says.
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

}  // namespace

Stored read_gdal(const std::string& place, const std::string& name, const ReadOptions& options, bool heights) {
  GdalCall call(name);
  call.hide(place);
  const DatasetPtr dataset = open_raster(call, place);
  check_size(*dataset, options.max_cells, call);
  const bool coded = options.coding != ElevationCoding::numbers;
  GDALRasterBand& band = checked_band(*dataset, options.band, heights && !coded, call);
  Flips flips;
  std::optional<Placement> placement = placement_of(*dataset, flips, call);
  const GDALDataType type = band.GetRasterDataType();
  const RunContext reading = options.run.part(0.0, 0.5);
  Stored stored{
      coded ? read_coded(*dataset, options.coding, flips, call, reading) : read_band(band, flips, call, reading), 0.0,
      format_name(*dataset), type_name(type)};
  const bool no_unit = options.unit.empty() && std::strlen(band.GetUnitType()) == 0 && band.GetScale() == 1.0;
  if (!coded && (type == GDT_Byte || type == GDT_UInt16) && no_unit) stored.code_max = type == GDT_Byte ? 255 : 65535;
  stored.ours = is_ours(*dataset);
  if (type != GDT_Byte && !stored.ours) take_out_void_codes(stored.values, name, heights, options.run);
  if (!coded) apply_scale(stored.values, band, heights ? height_unit(*dataset, band, options, call) : 1.0);
  if (placement) stored.crs = kept_crs(*dataset, placement->system);
  stored.placement = std::move(placement);
  stored.metres = heights;
  stored.local = is_local(*dataset);
  return stored;
}

RasterInfo gdal_info(const std::string& path) {
  GdalCall call(path);
  const DatasetPtr dataset = open_raster(call, path);
  check_size(*dataset, ReadOptions{}.max_cells, call);
  GDALRasterBand& band = checked_band(*dataset, std::nullopt, false, call);
  RasterInfo info;
  info.width = dataset->GetRasterXSize();
  info.height = dataset->GetRasterYSize();
  info.bands = dataset->GetRasterCount();
  info.format = format_name(*dataset);
  info.type = type_name(band.GetRasterDataType());
  Flips flips;
  const auto placement = placement_of(*dataset, flips, call);
  if (placement) {
    info.cell_x = placement->cell_x;
    info.cell_y = placement->cell_y;
    info.geographic = !placement->system.IsEmpty() && placement->system.IsGeographic() != 0;
    info.crs = kept_crs(*dataset, placement->system);
  }
  int has_nodata = 0;
  const double nodata = band.GetNoDataValue(&has_nodata);
  if (has_nodata != 0) info.nodata = nodata;
  Grid<float> values = read_band(band, flips, call, {});
  ReadOptions options;
  options.run.note = [&info](const std::string& line) { info.notes.push_back(line); };
  if (band.GetRasterDataType() != GDT_Byte && !is_ours(*dataset)) take_out_void_codes(values, path, true, options.run);
  const std::string spelled = band.GetUnitType();
  const bool length = spelled.empty() || metres_in_unit(spelled);
  if (!length) info.notes.push_back("values in " + spelled);
  apply_scale(values, band, length ? height_unit(*dataset, band, options, call) : 1.0);
  const char* ours = dataset->GetMetadataItem("SEAMOUNT_CRS");
  if (placement && (ours == nullptr || std::string_view(ours) != "local") &&
      must_be_degrees(*placement, values, true)) {
    info.geographic = true;
    const OGRSpatialReference lonlat = lonlat_system();
    info.crs = crs_text(&lonlat);
    info.notes.push_back("says nothing of its coordinate system; its numbers can only be degrees");
  }
  count_values(values, info);
  return info;
}

}  // namespace seamount::io

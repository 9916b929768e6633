// GeoTIFF, HGT and ASC through GDAL: reading.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/elevation_coding.h"
#include "seamount/io/gdal_band.h"
#include "seamount/io/raster_files.h"
#include "seamount/io/vertical_unit.h"
#include "seamount/io/void_codes.h"

namespace seamount::io {
namespace {

std::string format_name(GDALDataset& dataset) {
  const std::string driver = dataset.GetDriverName();
  if (driver == "GTiff") return "GeoTIFF";
  return driver == "AAIGrid" ? "ASC" : "HGT";
}

/// Cells per side and in all, before anything is allocated for them.
void check_size(GDALDataset& dataset, int64_t max_cells, const GdalCall& call) {
  const int64_t width = dataset.GetRasterXSize(), height = dataset.GetRasterYSize();
  if (width < 1 || height < 1) call.fail("is empty");
  if (width * height > max_cells)
    call.fail(std::to_string(width) + " x " + std::to_string(height) + " cells are more than the limit of " +
              std::to_string(max_cells));
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

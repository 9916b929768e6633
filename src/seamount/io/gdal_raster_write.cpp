// GeoTIFF and ASC: writing.
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/geotiff_tags.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

/// Adds a band that looks at cells.
void add_band(GDALDataset& dataset, void* cells, GDALDataType type) {
  CPLStringList place;
  char text[64];
  text[CPLPrintPointer(text, cells, sizeof(text) - 1)] = '\0';
  place.SetNameValue("DATAPOINTER", text);
  dataset.AddBand(type, place.List());
}

/// A dataset that looks at a grid's own cells.
DatasetPtr view_of(void* cells, GDALDataType type, const GridFrame& frame, const WriteOptions& options) {
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  DatasetPtr dataset(memory->Create("", frame.width, frame.height, 0, type, nullptr));
  add_band(*dataset, cells, type);
  tag_place(*dataset, frame, options.provenance);
  return dataset;
}

void copy_to_tiff(GDALDataset& source, const std::string& path, bool cloud_optimised, const char* predictor) {
  write_atomically(path, [&](const std::string& temporary) {
    GdalCall call(path);
    call.hide(temporary);
    CPLStringList how;
    how.SetNameValue("COMPRESS", "DEFLATE");
    how.SetNameValue("BIGTIFF", "IF_SAFER");
    how.SetNameValue("PREDICTOR", predictor);
    how.SetNameValue(cloud_optimised ? "LEVEL" : "ZLEVEL", "4");  // twice as fast as 6 for one hundredth more bytes
    if (!cloud_optimised) how.SetNameValue("TILED", "YES");
    if (cloud_optimised) how.SetNameValue("OVERVIEW_RESAMPLING", "AVERAGE");
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(cloud_optimised ? "COG" : "GTiff");
    DatasetPtr copy(driver->CreateCopy(temporary.c_str(), &source, FALSE, how.List(), nullptr, nullptr));
    if (!copy) call.fail("cannot be written");
    copy.reset();
    call.check("cannot be written");
  });
}

}  // namespace

void tag_place(GDALDataset& dataset, const GridFrame& frame, const Provenance& made) {
  double transform[] = {frame.west_m, frame.cell_m, 0.0, frame.north_m, 0.0, -frame.cell_m};
  dataset.SetGeoTransform(transform);
  if (const auto system = parse_crs(frame.crs)) {
    dataset.SetSpatialRef(system.get());
    dataset.SetMetadataItem("SEAMOUNT_CRS", frame.crs.c_str());
  } else {
    dataset.SetMetadataItem("SEAMOUNT_CRS", "local");  // so that nobody takes small cells for degrees
  }
  dataset.SetMetadataItem("AREA_OR_POINT", "Area");
  if (!made.program.empty()) dataset.SetMetadataItem("TIFFTAG_SOFTWARE", made.program.c_str());
  if (!made.recipe.empty()) dataset.SetMetadataItem("SEAMOUNT_RECIPE", made.recipe.c_str());
  if (made.seed) dataset.SetMetadataItem("SEAMOUNT_SEED", std::to_string(*made.seed).c_str());
}

void tag_heights(GDALDataset& dataset) {
  dataset.GetRasterBand(1)->SetUnitType("metre");
  dataset.GetRasterBand(1)->SetDescription("height above sea level");
  dataset.SetMetadataItem("VERTICAL_DATUM", "sea level is 0 m, up is positive");
}

void tag_regions(GDALDataset& dataset) {
  GDALColorTable colours;
  for (const Region region : kRegions) {
    const Colour c = painted_colour(region);
    const GDALColorEntry entry{c.r, c.g, c.b, 255};
    colours.SetColorEntry(static_cast<int>(region), &entry);
    dataset.SetMetadataItem(("LABEL_" + std::to_string(static_cast<int>(region))).c_str(),
                            std::string(region_name(region)).c_str());
  }
  dataset.GetRasterBand(1)->SetColorInterpretation(GCI_PaletteIndex);
  dataset.GetRasterBand(1)->SetColorTable(&colours);
}

void write_geotiff(const Grid<float>& grid, const std::string& path, const WriteOptions& options, bool heights) {
  const GdalCall call(path);
  const DatasetPtr view = view_of(const_cast<float*>(grid.data()), GDT_Float32, grid.frame(), options);
  if (has_voids(grid)) view->GetRasterBand(1)->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  if (heights) tag_heights(*view);
  const char* predictor = options.cloud_optimised ? "FLOATING_POINT" : "3";
  copy_to_tiff(*view, path, options.cloud_optimised, predictor);
}

void write_geotiff_current(const VectorField& current, const std::string& path, const WriteOptions& options) {
  const GdalCall call(path);
  const DatasetPtr view = view_of(const_cast<float*>(current.x.data()), GDT_Float32, current.frame(), options);
  add_band(*view, const_cast<float*>(current.y.data()), GDT_Float32);
  const bool voids = has_voids(current.x) || has_voids(current.y);
  for (int b = 1; b <= 2; ++b) {
    GDALRasterBand& band = *view->GetRasterBand(b);
    band.SetDescription(b == 1 ? "eastward current" : "northward current");
    band.SetUnitType("m/s");
    if (voids) band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  }
  copy_to_tiff(*view, path, options.cloud_optimised, options.cloud_optimised ? "FLOATING_POINT" : "3");
}

void write_geotiff8(const Grid<uint8_t>& grid, const std::string& path, const WriteOptions& options, bool labels) {
  const GdalCall call(path);
  const DatasetPtr view = view_of(const_cast<uint8_t*>(grid.data()), GDT_Byte, grid.frame(), options);
  if (labels) tag_regions(*view);
  copy_to_tiff(*view, path, options.cloud_optimised, options.cloud_optimised ? "NO" : "1");
}

void write_asc(const Grid<float>& grid, const std::string& path) {
  const GridFrame& frame = grid.frame();
  const auto system = parse_crs(frame.crs);
  constexpr std::string_view kUsual = "-9999", kLowest = "-3.4e+38";
  const bool usual = has_voids(grid) && known_range(grid).low_m > -9000;
  const std::string none(usual ? kUsual : kLowest);
  std::string text = "ncols " + std::to_string(frame.width) + "\nnrows " + std::to_string(frame.height) +
                     "\nxllcorner " + format_number(frame.west_m) + "\nyllcorner " + format_number(frame.south_m()) +
                     "\ncellsize " + format_number(frame.cell_m) + "\nNODATA_value " + none + "\n";
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      char number[32];
      const auto end = std::to_chars(number, number + sizeof(number), grid(x, y)).ptr;
      const std::string_view shown = std::isnan(grid(x, y)) ? std::string_view(none) : std::string_view(number, end);
      text += shown;
      // GDAL takes a raster without a decimal point for integers.
      if (x == 0 && y == 0 && shown.find_first_of(".e") == std::string_view::npos) text += ".0";
      text += x + 1 < frame.width ? ' ' : '\n';
    }
  }
  write_text(path, text);
  const std::string prj = path.substr(0, path.size() - extension_of(path).size()) + ".prj";
  std::error_code none_there;
  if (!system) std::filesystem::remove(prj, none_there);  // of the earlier file
  if (system) {
    char* wkt = nullptr;
    constexpr const char* const kEsri[] = {"FORMAT=WKT1_ESRI", nullptr};
    system->exportToWkt(&wkt, kEsri);
    const std::string esri = wkt != nullptr ? wkt : "";
    CPLFree(wkt);
    write_text(prj, esri + "\n");
  }
}

}  // namespace seamount::io

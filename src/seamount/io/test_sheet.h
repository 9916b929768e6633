// Contours as GDAL draws them, for tests.
#pragma once

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <string>
#include <vector>

#include "seamount/io/gdal_call.h"

namespace seamount::io {

/// Where a raster lies: its north-western corner and its cells, in units of its system.
struct Sheet {
  std::string crs;
  double west, north, cell;
};

/// Writes the contours of side * side heights to a GeoPackage, their heights in the field ELEV.
inline bool write_contours(const std::string& path, const Sheet& sheet, const std::vector<float>& heights, int side,
                           double interval) {
  const GdalCall call(path);
  const auto system = parse_crs(sheet.crs);
  GDALDriverManager& drivers = *GetGDALDriverManager();
  const DatasetPtr raster(drivers.GetDriverByName("MEM")->Create("", side, side, 1, GDT_Float32, nullptr));
  double transform[6] = {sheet.west, sheet.cell, 0, sheet.north, 0, -sheet.cell};
  raster->SetGeoTransform(transform);
  GDALRasterBand* band = raster->GetRasterBand(1);
  if (band->RasterIO(GF_Write, 0, 0, side, side, const_cast<float*>(heights.data()), side, side, GDT_Float32, 0, 0,
                     nullptr) != CE_None)
    return false;
  const DatasetPtr lines(drivers.GetDriverByName("GPKG")->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRLayer* layer = lines->CreateLayer("contour", system.get(), wkbLineString, nullptr);
  OGRFieldDefn id("ID", OFTInteger), elev("ELEV", OFTReal);
  layer->CreateField(&id);
  layer->CreateField(&elev);
  return GDALContourGenerate(band, interval, 0, 0, nullptr, FALSE, 0, OGRLayer::ToHandle(layer), 0, 1, nullptr,
                             nullptr) == CE_None;
}

}  // namespace seamount::io

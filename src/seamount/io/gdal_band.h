// What GDAL says of a raster and the band of it that is read. Not part of the public interface.
#pragma once

#include <optional>
#include <string>

#include "seamount/io/gdal_call.h"
#include "seamount/io/placement.h"
#include "seamount/io/read_options.h"

namespace seamount::io {

/// Opens a GeoTIFF, HGT or ASC file. Throws IoError; of HGT files it says what they must be called, which few know.
DatasetPtr open_raster(const GdalCall& call, const std::string& place);

/// "float32", "uint16", ...
std::string type_name(GDALDataType type);

/// Throws IoError for blocks that are far larger than the raster: GDAL reads them as a whole.
void check_blocks(GDALDataset& dataset, GDALRasterBand& band, const GdalCall& call);

/// The band that is asked for, or the first. Heights are not looked for in a picture unless its band is named.
GDALRasterBand& checked_band(GDALDataset& dataset, std::optional<int> wanted, bool heights, const GdalCall& call);

/// Which way the rows and columns of a file run, where it is not from north to south and from west to east.
struct Flips {
  bool south_up = false;
  bool east_first = false;
};

/// Where the file says that it lies; nullopt: nowhere. Throws IoError for a rotated raster.
std::optional<Placement> placement_of(GDALDataset& dataset, Flips& flips, const GdalCall& call);

/// Metres in one unit of a band's heights: as told, else as the band says, else as the file's vertical system does.
double height_unit(GDALDataset& dataset, GDALRasterBand& band, const ReadOptions& options, const GdalCall& call);

/// Was it written by us?
bool is_ours(GDALDataset& dataset);
/// And in metres without a system?
bool is_local(GDALDataset& dataset);
/// Our own text of the system, if it still says what the file's system says.
std::string kept_crs(GDALDataset& dataset, const OGRSpatialReference& system);

}  // namespace seamount::io

// Elevation and other rasters from and to files.
//
// Read:  GeoTIFF/COG, SRTM HGT, Arc/Info ASC, PNG (8, 16 bit grey), EXR, R16/R32/RAW (square, little endian), NPY.
// Write: .tif .asc .png .exr .r16 .raw .r32 .npy, by extension.
//
// What a file does not say must be told: an unsigned integer image without side-car (sidecar.h) needs
// ReadOptions::range, a file without georeference needs ReadOptions::cell_m. Both are errors that say so, never a
// guess. Float, signed and georeferenced files hold metres (vertical feet in a GeoTIFF are converted).
//
// Rasters in degrees, feet, oblong cells or metres that are off by more than 1 % (Web Mercator far from the equator)
// are warped (bilinear) to square cells in metres that cover the largest upright rectangle inside the raster, about as
// many cells as before: degrees to a local transverse Mercator (projection.h), at most 20 degrees of longitude across.
//
// Cells without a value are those that the file says, and those that hold one of the usual codes for it or a height
// that cannot be (void_codes.h). A file without a system whose numbers can only be degrees is taken so. Whatever is
// taken for granted is said through ReadOptions::run.
//
// Everything here throws IoError{path} with one line: missing, truncated, too large, not a raster, rotated.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "seamount/io/read_options.h"
#include "seamount/io/sidecar.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"

namespace seamount::io {

/// What a raster file says of itself, without its cells being kept.
struct RasterInfo {
  int width = 0, height = 0;
  int bands = 1;
  double cell_x = 0.0, cell_y = 0.0;  ///< metres, or degrees where geographic; 0: not stated
  bool geographic = false;            ///< cells are in degrees
  std::string crs;                    ///< "EPSG:32604" or WKT; empty: none
  std::string format;                 ///< "GeoTIFF", "PNG", ...
  std::string type;                   ///< "float32", "uint16", ...
  std::optional<double> nodata;
  double min = 0.0, max = 0.0;     ///< over valid cells, as stored (codes, not metres, for integer images)
  int64_t void_cells = 0;          ///< nodata or not finite
  std::vector<std::string> notes;  ///< what was taken for granted
};

struct WriteOptions {
  std::optional<HeightRange> range;  ///< of 16-bit formats; default: the field's own minimum and maximum
  bool cloud_optimised = false;      ///< .tif only: tiles and overviews in COG order
  bool sidecar = true;               ///< beside formats that cannot say their own scale
  int ground_width = 0;              ///< of a padded tile, for the side-car: see Sidecar
  int ground_height = 0;
  Provenance provenance;
};

/// Reads the whole file once for the extremes. Cost: a read.
RasterInfo raster_info(const std::string& path);

/// Heights in metres, row 0 north; NaN where none is known. Formats are told apart by extension, GIS formats by
/// content.
HeightField read_heights(const std::string& path, const ReadOptions& options = {});
/// The same from memory; `name` gives the extension and stands in messages. No side-car.
HeightField read_heights(std::span<const uint8_t> bytes, const std::string& name, const ReadOptions& options = {});

/// Any other scalar: the same, but no units are converted.
ScalarField read_field(const std::string& path, const ReadOptions& options = {});

/// A selection: integer formats are scaled to [0, 1] unless options.range says otherwise.
Mask read_mask(const std::string& path, const ReadOptions& options = {});

/// Regions from a GeoTIFF of their numbers (mountain 0 ... abyss 4). A picture of regions is read_placed_image() and
/// geom/grid/painted_labels.h.
LabelMap read_labels(const std::string& path, const ReadOptions& options = {});

/// A picture and where its side-car says that it lies.
struct PlacedImage {
  Image image;
  GridFrame frame;
};
PlacedImage read_placed_image(const std::string& path, const ReadOptions& options = {});

/// GeoTIFF: float32, tiled, deflate with the floating point predictor, pixel is area, "0 m is sea level" as metadata;
/// CRS and geotransform come back exactly. 16-bit formats come back within half of range / 65535. Unknown cells (NaN)
/// are declared: the no-data value nan of GeoTIFF, -9999 or, where that is a height, -3.4e38 of ASC, NaN of EXR, NPY
/// and R32; 16-bit formats cannot hold them and throw InvalidArgument{"heights"}.
void write_heights(const HeightField& heights, const std::string& path, const WriteOptions& options = {});

/// Any other scalar: the same without the vertical datum.
void write_field(const ScalarField& field, const std::string& path, const WriteOptions& options = {});

/// A selection as 8 bits: .png or .tif, 0..255 for [0, 1] (clamped); other extensions as write_field.
void write_mask(const Mask& mask, const std::string& path, const WriteOptions& options = {});

/// .tif: 8 bit, palette and category names; .png: the colours of model/label_map.h.
void write_labels(const LabelMap& labels, const std::string& path, const WriteOptions& options = {});

/// Whether a format, by extension, can say that a cell is unknown: all but those of 16-bit codes.
bool can_hold_voids(const std::string& path);

/// All files that writing a raster to `path` makes: itself, and a side-car where the format cannot say its own scale.
std::vector<std::string> written_files(const std::string& path);

/// Extensions that read_heights() and write_heights() know, with their dots.
const std::vector<std::string>& readable_raster_extensions();
const std::vector<std::string>& writable_raster_extensions();

}  // namespace seamount::io

// One function pair per raster format. Readers take bytes in memory and give a Stored raster: values as the file has
// them, with what it says about place and meaning. Not part of the public interface; raster.h puts them together.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "seamount/io/placement.h"
#include "seamount/io/raster.h"
#include "seamount/model/vector_field.h"

namespace seamount::io {

/// A raster as stored.
struct Stored {
  Grid<float> values;     ///< row 0 north; NaN: no value. Only the size of the frame is right.
  double code_max = 0.0;  ///< highest code of an unsigned integer image that has no unit (255, 65535); 0: real values
  std::string format, type;
  std::optional<Placement> placement = {};  ///< where it says that it lies
  std::string crs = {};                     ///< of the placement, as text
  bool metres = false;                      ///< heights whose unit is settled
  bool local = false;                       ///< it says that it lies in metres without a system
  bool ours = false;                        ///< written by us: its heights are what they are
};

/// What the numbers of a raster are.
enum class Meaning { heights, field, mask };

/// A raster file before it is brought to its place: without codes for voids, its heights in metres unless a range is to
/// be applied.
struct Loaded {
  Stored stored;
  std::optional<Sidecar> sidecar;
};
Loaded load_raster(const std::string& path, const ReadOptions& options, Meaning meaning);

/// True if a place without a system can only be in degrees: on the globe, and no metres because the land would be
/// steeper than anything.
bool must_be_degrees(const Placement& placement, const Grid<float>& values, bool heights);
/// The same of a raster that is not in memory. `relief`: between its lowest and its highest value.
bool must_be_degrees(const Placement& placement, int columns, int rows, double relief, bool heights);
/// What is said of one that is taken for degrees.
void say_degrees(const std::string& name, const RunContext& run);
/// What is said where cell_m is given for a file that states its own cells.
void say_own_cells(const std::string& name, double own_m, double told_m, const RunContext& run);
/// Says how many cells have no value. Throws IoError if none has.
void say_voids(int64_t unknown, int64_t all, const std::string& name, const RunContext& run);

/// Settles in which system a stored raster with a placement lies: the one that is told, the file's own, or degrees
/// where its numbers can be nothing else, which is said.
void choose_system(Stored& stored, const std::string& name, const ReadOptions& options, Meaning meaning);

/// The rest of reading: place, range, plausible heights, voids.
Grid<float> finish_raster(Loaded loaded, const std::string& name, const ReadOptions& options, Meaning meaning);

/// .npy versions 1 to 3, C order, two dimensions, little-endian f4 f8 or u1 u2 i2.
Stored decode_npy(std::span<const uint8_t> file, const std::string& name, int64_t max_cells);
void encode_npy(const Grid<float>& grid, const std::string& temporary, const std::string& path);

/// .exr: the channel Y, else Z, height or R, else the only one.
Stored decode_exr(std::span<const uint8_t> file, const std::string& name, int64_t max_cells);
/// One float channel. "Y" is luminance, which Blender, Nuke and GDAL read as grey; Godot makes three equal channels of
/// it, but one, as its terrains want, of a lone "R".
void encode_exr(const Grid<float>& grid, const std::string& temporary, const std::string& path,
                const char* channel = "Y");

/// .r16 .raw (16 bit, in options.byte_order) and .r32 (float, little endian), without header: square unless width and
/// height are given. Says so where the other byte order gives a much smoother raster.
Stored decode_raw(std::span<const uint8_t> file, const std::string& name, const ReadOptions& options,
                  std::optional<std::pair<int, int>> size);

/// .png of 8 or 16 bits whose colours, if it has them, are all grey, or heights in options.coding, then at its place if
/// its name is a slippy-map tile's. Transparent pixels are NaN.
Stored decode_png_heights(std::span<const uint8_t> file, const std::string& name, const ReadOptions& options);

/// GeoTIFF, HGT and ASC through GDAL; `place` is a file or a /vsimem/ name. Vertical units become metres if these are
/// heights.
Stored read_gdal(const std::string& place, const std::string& name, const ReadOptions& options, bool heights);
RasterInfo gdal_info(const std::string& path);
void write_geotiff(const Grid<float>& grid, const std::string& path, const WriteOptions& options, bool heights);
/// Two bands: east and north components in m/s.
void write_geotiff_current(const VectorField& current, const std::string& path, const WriteOptions& options);
void write_geotiff8(const Grid<uint8_t>& grid, const std::string& path, const WriteOptions& options, bool labels);
void write_asc(const Grid<float>& grid, const std::string& path);

/// 16-bit codes of heights: round((z - low) / (high - low) * 65535), clamped.
Grid<uint16_t> to_codes(const Grid<float>& heights, HeightRange range);

/// The extremes; throws InvalidArgument{"heights"} for an empty grid or a cell that is not finite.
HeightRange finite_range(const Grid<float>& grid);

/// The extremes of the known cells of a grid for a format that can say that others are not (NaN); throws
/// InvalidArgument{"heights"} for a grid without a known cell or with an infinite one.
HeightRange known_range(const Grid<float>& grid);

/// Whether any cell is unknown (NaN).
bool has_voids(const Grid<float>& grid);

/// The range to code a grid with: options.range, else its extremes, one metre apart at least.
HeightRange coding_range(const Grid<float>& grid, const std::optional<HeightRange>& asked);

/// Extremes and voids of `grid` into `info`.
void count_values(const Grid<float>& grid, RasterInfo& info);

/// Writes 16-bit codes as .png or little-endian raw by extension, without a side-car.
void write_codes(const Grid<uint16_t>& codes, const std::string& path);

}  // namespace seamount::io

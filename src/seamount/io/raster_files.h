// One function pair per raster format. Readers take bytes in memory and give a Stored raster: values as the file has
// them, with what it says about place and meaning. Not part of the public interface; raster.h puts them together.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "seamount/io/raster.h"

namespace seamount::io {

/// A raster as stored.
struct Stored {
  Grid<float> values;  ///< row 0 north; NaN: no value. The frame's size is right; the rest only if georeferenced.
  bool georeferenced = false;
  double code_max = 0.0;  ///< highest code of an unsigned integer image that has no unit (255, 65535); 0: real values
  std::string format, type;
};

/// .npy versions 1 to 3, C order, two dimensions, little-endian f4 f8 or u1 u2 i2.
Stored decode_npy(std::span<const uint8_t> file, const std::string& name, int64_t max_cells);
void encode_npy(const Grid<float>& grid, const std::string& temporary, const std::string& path);

/// .exr: the channel Y, else Z, height or R, else the only one.
Stored decode_exr(std::span<const uint8_t> file, const std::string& name, int64_t max_cells);
/// One float channel. "Y" is luminance, which Blender, Nuke and GDAL read as grey; Godot makes three equal channels of
/// it, but one, as its terrains want, of a lone "R".
void encode_exr(const Grid<float>& grid, const std::string& temporary, const std::string& path,
                const char* channel = "Y");

/// .r16 .raw (16 bit) and .r32 (float), little endian, without header: square unless width and height are given.
Stored decode_raw(std::span<const uint8_t> file, const std::string& name, int64_t max_cells,
                  std::optional<std::pair<int, int>> size);

/// .png grey, 8 or 16 bit.
Stored decode_png_heights(std::span<const uint8_t> file, const std::string& name, int64_t max_cells);

/// GeoTIFF, HGT and ASC through GDAL; `place` is a file or a /vsimem/ name. What has a place is warped to square metric
/// cells; vertical units become metres if these are heights.
Stored read_gdal(const std::string& place, const std::string& name, const ReadOptions& options, bool heights);
RasterInfo gdal_info(const std::string& path);
void write_geotiff(const Grid<float>& grid, const std::string& path, const WriteOptions& options, bool heights);
void write_geotiff8(const Grid<uint8_t>& grid, const std::string& path, const WriteOptions& options, bool labels);
void write_asc(const Grid<float>& grid, const std::string& path);

/// 16-bit codes of heights: round((z - low) / (high - low) * 65535), clamped.
Grid<uint16_t> to_codes(const Grid<float>& heights, HeightRange range);

/// The extremes; throws InvalidArgument{"heights"} for an empty grid or a cell that is not finite.
HeightRange finite_range(const Grid<float>& grid);

/// The range to code a grid with: options.range, else its extremes, one metre apart at least.
HeightRange coding_range(const Grid<float>& grid, const std::optional<HeightRange>& asked);

/// Extremes and voids of `grid` into `info`.
void count_values(const Grid<float>& grid, RasterInfo& info);

/// Writes 16-bit codes as .png or little-endian raw by extension, without a side-car.
void write_codes(const Grid<uint16_t>& codes, const std::string& path);

}  // namespace seamount::io

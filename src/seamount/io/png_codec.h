// PNG samples of any channel count, 8 or 16 bit, through libpng. Used by the raster, image, engine and splat writers.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace seamount::io {

/// Samples of a PNG, row 0 on top, channels interleaved, 16-bit ones in the machine's order.
struct PngSamples {
  int width = 0, height = 0;
  int channels = 1;  ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
  int bits = 8;      ///< 8 or 16; smaller depths are widened to 8
  std::vector<uint8_t> bytes8;
  std::vector<uint16_t> words16;
};

/// Palettes become RGB. Throws IoError{name} for anything broken, truncated or above max_pixels.
PngSamples decode_png_samples(std::span<const uint8_t> file, const std::string& name, int64_t max_pixels);

/// Size, channels and bits alone.
PngSamples png_header(std::span<const uint8_t> file, const std::string& name);

std::vector<uint8_t> encode_png8(std::span<const uint8_t> samples, int width, int height, int channels);
std::vector<uint8_t> encode_png16(std::span<const uint16_t> samples, int width, int height);

/// 8 bits a channel, rows made one at a time: for pictures that need not be in memory.
std::vector<uint8_t> encode_png_rows(int width, int height, int channels,
                                     const std::function<void(int y, std::span<uint8_t> row)>& fill);

bool is_png(std::span<const uint8_t> file);

}  // namespace seamount::io

// Pictures from and to files: PNG and JPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "seamount/model/image.h"

namespace seamount::io {

/// Reads PNG (any kind: grey, palette, 16 bit, alpha over white) or JPEG as 8-bit RGB. At most 300 million pixels.
/// Throws IoError.
Image read_image(const std::string& path);
/// The same from memory; `name` stands in messages.
Image read_image(std::span<const uint8_t> bytes, const std::string& name);

/// 8-bit RGB, the same bytes for the same picture.
std::vector<uint8_t> encode_png(const Image& image);
void write_png(const Image& image, const std::string& path);

/// The same bytes for the same picture and library. Quality 1 to 100. Throws IoError{name} beyond 65500 pixels a side.
std::vector<uint8_t> encode_jpeg(const Image& image, int quality, const std::string& name = "picture.jpg");

/// Endings that write_picture() knows: ".png", ".jpg", ".jpeg".
const std::vector<std::string>& picture_extensions();

/// PNG, or JPEG of quality 92 by the name's ending. Throws IoError for other endings, naming those that there are.
void write_picture(const Image& image, const std::string& path);

}  // namespace seamount::io

// Pictures from and to files: PNG both ways, JPEG in.
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

}  // namespace seamount::io

// Raw and PNG codes: integers that need a range to be heights.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {

Stored decode_raw(std::span<const uint8_t> file, const std::string& name, int64_t max_cells,
                  std::optional<std::pair<int, int>> size) {
  const bool floats = extension_of(name) == ".r32";
  const size_t sample = floats ? 4 : 2;
  const size_t samples = file.size() / sample;
  if (file.empty()) throw IoError(name, "is empty");
  if (static_cast<int64_t>(samples) > max_cells)
    throw IoError(name, "has more than " + std::to_string(max_cells) + " cells");
  if (!size) {
    const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(samples))));
    size = std::pair(side, side);
  }
  const auto [width, height] = *size;
  if (static_cast<size_t>(width) * static_cast<size_t>(height) * sample != file.size())
    throw IoError(name, std::to_string(file.size()) + " bytes are not " + std::to_string(width) + " x " +
                            std::to_string(height) + (floats ? " floats" : " 16-bit samples") +
                            "; a raw file must be square unless the side-car '" + sidecar_path(name) +
                            "' gives its width and height");
  Stored stored{Grid<float>(GridFrame{width, height}), false, floats ? 0.0 : 65535.0, floats ? "R32" : "R16",
                floats ? "float32" : "uint16"};
  const std::span<float> to = stored.values.cells();
  if (floats) {
    std::memcpy(to.data(), file.data(), file.size());
  } else {
    for (size_t i = 0; i < to.size(); ++i) to[i] = static_cast<float>(file[2 * i] | file[2 * i + 1] << 8);
  }
  return stored;
}

Stored decode_png_heights(std::span<const uint8_t> file, const std::string& name, int64_t max_cells) {
  const PngSamples samples = decode_png_samples(file, name, max_cells);
  if (samples.channels > 2) throw IoError(name, "is a colour picture; a height image is grey, 8 or 16 bit");
  const auto channels = static_cast<size_t>(samples.channels);
  const bool deep = samples.bits == 16;
  Stored stored{Grid<float>(GridFrame{samples.width, samples.height}), false, deep ? 65535.0 : 255.0, "PNG",
                deep ? "uint16" : "uint8"};
  const std::span<float> to = stored.values.cells();
  for (size_t i = 0; i < to.size(); ++i)
    to[i] = deep ? samples.words16[i * channels] : static_cast<float>(samples.bytes8[i * channels]);
  return stored;
}

Grid<uint16_t> to_codes(const Grid<float>& heights, HeightRange range) {
  Grid<uint16_t> codes(heights.frame());
  const double scale = 65535.0 / (range.high_m - range.low_m);
  for (size_t i = 0; i < codes.size(); ++i) {
    const double code = std::floor((heights.cells()[i] - range.low_m) * scale + 0.5);
    codes.cells()[i] = static_cast<uint16_t>(std::clamp(code, 0.0, 65535.0));
  }
  return codes;
}

HeightRange finite_range(const Grid<float>& grid) {
  if (grid.empty()) throw InvalidArgument("heights", "there are no cells");
  float low = grid.cells()[0], high = low;
  for (size_t i = 0; i < grid.size(); ++i) {
    const float z = grid.cells()[i];
    if (!std::isfinite(z)) {
      const size_t width = static_cast<size_t>(grid.width());
      throw InvalidArgument("heights", "cell (" + std::to_string(i % width) + ", " + std::to_string(i / width) +
                                           ") is " + format_number(z) + ", not a number to write");
    }
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return {low, high};
}

HeightRange coding_range(const Grid<float>& grid, const std::optional<HeightRange>& asked) {
  if (asked) {
    if (!std::isfinite(asked->low_m) || !std::isfinite(asked->high_m) || !(asked->high_m > asked->low_m))
      throw InvalidArgument("range", "low_m must be below high_m");
    return *asked;
  }
  HeightRange range = finite_range(grid);
  if (range.high_m - range.low_m < 1.0) range = {range.low_m - 0.5, range.high_m + 0.5};
  return range;
}

void write_codes(const Grid<uint16_t>& codes, const std::string& path) {
  if (extension_of(path) == ".png") {
    write_bytes(path, encode_png16(codes.cells(), codes.width(), codes.height()));
  } else {
    write_bytes(path, {reinterpret_cast<const uint8_t*>(codes.data()), codes.size() * 2});
  }
}

}  // namespace seamount::io

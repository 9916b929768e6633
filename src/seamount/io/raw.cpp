// Raw and PNG codes: integers that need a range to be heights.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/elevation_coding.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {

namespace {

/// The mean step between neighbours in rows of 16-bit samples, of either byte order: {little, big}.
std::array<double, 2> roughness(std::span<const uint8_t> file, size_t width) {
  std::array<double, 2> sum{};
  for (size_t i = 1; i < file.size() / 2; ++i) {
    if (i % width == 0) continue;
    const uint8_t* here = &file[2 * i];
    sum[0] += std::abs((here[0] | here[1] << 8) - (here[-2] | here[-1] << 8));
    sum[1] += std::abs((here[1] | here[0] << 8) - (here[-1] | here[-2] << 8));
  }
  return sum;
}

void read_samples(std::span<const uint8_t> file, const std::string& name, const ReadOptions& options, size_t width,
                  std::span<float> to) {
  const bool big = options.byte_order == ByteOrder::big;
  const size_t low = big ? 1 : 0, high = big ? 0 : 1;
  for (size_t i = 0; i < to.size(); ++i) to[i] = static_cast<float>(file[2 * i + low] | file[2 * i + high] << 8);
  constexpr double kMuchRougher = 4.0;
  const auto rough = roughness(file, width);
  if (rough[big ? 1 : 0] > kMuchRougher * rough[big ? 0 : 1])
    options.run.say(name + ": looks like noise with the " + (big ? "high" : "low") +
                    " byte of each sample first and smooth the other way; try byte_order " +
                    (big ? "\"little\"" : "\"big\""));
}

/// Whether red, green and blue are alike in every pixel.
bool all_grey(const PngSamples& samples) {
  if (samples.channels < 3) return true;
  const auto step = static_cast<size_t>(samples.channels);
  const auto alike = [step](const auto& values) {
    for (size_t i = 0; i < values.size(); i += step)
      if (values[i] != values[i + 1] || values[i] != values[i + 2]) return false;
    return true;
  };
  return samples.bits == 16 ? alike(samples.words16) : alike(samples.bytes8);
}

}  // namespace

Stored decode_raw(std::span<const uint8_t> file, const std::string& name, const ReadOptions& options,
                  std::optional<std::pair<int, int>> size) {
  const bool floats = extension_of(name) == ".r32";
  const size_t sample = floats ? 4 : 2;
  const size_t samples = file.size() / sample;
  if (file.empty()) throw IoError(name, "is empty");
  if (static_cast<int64_t>(samples) > options.max_cells)
    throw IoError(name, "has more than " + std::to_string(options.max_cells) + " cells");
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
  Stored stored{Grid<float>(GridFrame{width, height}), floats ? 0.0 : 65535.0, floats ? "R32" : "R16",
                floats ? "float32" : "uint16"};
  const std::span<float> to = stored.values.cells();
  if (floats)
    std::memcpy(to.data(), file.data(), file.size());
  else
    read_samples(file, name, options, static_cast<size_t>(width), to);
  return stored;
}

Stored decode_png_heights(std::span<const uint8_t> file, const std::string& name, const ReadOptions& options) {
  const PngSamples samples = decode_png_samples(file, name, options.max_cells);
  const bool coded = options.coding != ElevationCoding::numbers;
  const bool deep = samples.bits == 16;
  if (coded && (samples.channels < 3 || deep))
    throw IoError(name, "is not a colour picture of 8 bits a channel, which heights coded in colours are");
  const int band = options.band.value_or(1);
  if (band < 1 || band > samples.channels)
    throw IoError(
        name, "has " + std::to_string(samples.channels) + " channels, band " + std::to_string(band) + " was asked for");
  if (!coded && !options.band && !all_grey(samples))
    throw IoError(name,
                  "is a colour picture; a height image is grey, 8 or 16 bit, unless the coding of heights in its "
                  "colours is named: terrarium or mapbox");
  const auto channels = static_cast<size_t>(samples.channels);
  Stored stored{Grid<float>(GridFrame{samples.width, samples.height}),
                coded  ? 0.0
                : deep ? 65535.0
                       : 255.0,
                "PNG", deep ? "uint16" : "uint8"};
  const std::span<float> to = stored.values.cells();
  const auto value = [&](size_t i) -> float { return deep ? samples.words16[i] : samples.bytes8[i]; };
  for (size_t i = 0; i < to.size(); ++i) {
    const size_t at = i * channels;
    to[i] = coded ? coded_height(options.coding, value(at), value(at + 1), value(at + 2))
                  : value(at + static_cast<size_t>(band - 1));
    if (channels % 2 == 0 && value(at + channels - 1) == 0) to[i] = std::numeric_limits<float>::quiet_NaN();
  }
  if (coded) stored.placement = slippy_placement(name, samples.width);
  if (stored.placement) stored.crs = crs_text(&stored.placement->system);
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

namespace {

[[noreturn]] void refuse_cell(const Grid<float>& grid, size_t i) {
  const auto width = static_cast<size_t>(grid.width());
  throw InvalidArgument("heights", "cell (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ") is " +
                                       format_number(grid.cells()[i]) + ", not a number to write");
}

HeightRange range_of(const Grid<float>& grid, bool voids) {
  if (grid.empty()) throw InvalidArgument("heights", "there are no cells");
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (size_t i = 0; i < grid.size(); ++i) {
    const float z = grid.cells()[i];
    if (voids && std::isnan(z)) continue;
    if (!std::isfinite(z)) refuse_cell(grid, i);
    low = std::min(low, z);
    high = std::max(high, z);
  }
  if (low > high) throw InvalidArgument("heights", "none of the cells has a value");
  return {low, high};
}

}  // namespace

HeightRange finite_range(const Grid<float>& grid) { return range_of(grid, false); }

HeightRange known_range(const Grid<float>& grid) { return range_of(grid, true); }

bool has_voids(const Grid<float>& grid) {
  return std::any_of(grid.cells().begin(), grid.cells().end(), [](float z) { return std::isnan(z); });
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

#include "seamount/io/engine.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

constexpr double kCodes = 65535.0;

/// Smallest number of at most four digits that is not below a positive one: 97.6123 -> 97.62.
double rounded_up(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 3);
  return std::ceil(value / unit - 1e-9) * unit;
}

/// Text of a double that was put together from a few digits, without the noise of its last bits.
double tidy(double value) { return std::round(value * 1e8) / 1e8; }

/// Unreal: a code stands for (code - 32768) / 128 cm times the actor's Z scale, above the actor's Z location. Both are
/// typed in by hand, so they are chosen first, short, and the range follows.
struct UnrealScale {
  double z_scale = 100, z_location_cm = 0;

  HeightRange range() const {
    const double step_m = z_scale / 12800.0;
    return {z_location_cm / 100.0 - 32768.0 * step_m, z_location_cm / 100.0 + 32767.0 * step_m};
  }
};

UnrealScale unreal_scale(HeightRange heights, const EngineOptions& options) {
  if (options.range) {
    const double step_m = (options.range->high_m - options.range->low_m) / kCodes;
    return {step_m * 12800.0, 100.0 * (options.range->low_m + 32768.0 * step_m)};
  }
  const double range_m = std::max(heights.high_m - heights.low_m, 1.0) * 4.0 / 3.0;
  return {tidy(rounded_up(range_m / kCodes * 12800.0)), std::round(50.0 * (heights.low_m + heights.high_m))};
}

/// Any other 16-bit target: lowest height and range in whole decimetres.
HeightRange plain_range(HeightRange heights, const EngineOptions& options) {
  if (options.range) return *options.range;
  const double range_m = std::max(heights.high_m - heights.low_m, 1.0) * 4.0 / 3.0;
  const double middle = 0.5 * (heights.low_m + heights.high_m);
  const double low = std::floor((middle - 0.5 * range_m) * 10.0) / 10.0;
  return {tidy(low), tidy(low + std::ceil(range_m * 10.0 + 1.0) / 10.0)};
}

void check_size(const HeightField& heights, Engine engine) {
  const std::vector<int>& sizes = engine_sizes(engine);
  if (sizes.empty()) return;
  const bool known = std::find(sizes.begin(), sizes.end(), heights.width()) != sizes.end();
  if (known && heights.width() == heights.height()) return;
  std::string list;
  for (const int size : sizes) list += (list.empty() ? "" : ", ") + std::to_string(size);
  throw InvalidArgument("size", std::to_string(heights.width()) + " x " + std::to_string(heights.height()) +
                                    " is not a size that " +
                                    std::string(Choices<Engine>::names[static_cast<size_t>(engine)]) +
                                    " reads; allowed are squares of: " + list);
}

void check_range(HeightRange heights, HeightRange range) {
  if (!std::isfinite(range.low_m) || !std::isfinite(range.high_m) || !(range.high_m > range.low_m))
    throw InvalidArgument("range", "low_m must be below high_m");
  const double half_step = 0.5 * (range.high_m - range.low_m) / kCodes;
  if (heights.low_m < range.low_m - half_step || heights.high_m > range.high_m + half_step)
    throw InvalidArgument("range", "[" + format_number(range.low_m) + ", " + format_number(range.high_m) +
                                       "] does not hold the heights " + format_number(heights.low_m) + " to " +
                                       format_number(heights.high_m) + " m");
}

std::vector<ImportNumber> unreal_numbers(const GridFrame& frame, UnrealScale scale) {
  const std::string xy = format_number(tidy(100.0 * frame.cell_m));
  return {{"Scale X", xy},
          {"Scale Y", xy},
          {"Scale Z", format_number(scale.z_scale)},
          {"Location Z", format_number(scale.z_location_cm)},
          {"note", "centimetres; with this location sea level is at z = 0"}};
}

std::vector<ImportNumber> unity_numbers(const GridFrame& frame, HeightRange range) {
  return {{"Terrain Width", format_number(tidy(frame.cell_m * (frame.width - 1)))},
          {"Terrain Length", format_number(tidy(frame.cell_m * (frame.height - 1)))},
          {"Terrain Height", format_number(tidy(range.high_m - range.low_m))},
          {"Position Y", format_number(range.low_m)},
          {"Resolution", std::to_string(frame.width)},
          {"Byte Order", "Windows"},
          {"Flip Vertically", "off"}};
}

std::vector<ImportNumber> metric_numbers(Engine engine, const GridFrame& frame, const Sidecar& sidecar) {
  if (engine == Engine::godot) {
    std::vector<ImportNumber> numbers{{"vertex spacing", format_number(frame.cell_m)}, {"import scale", "1"}};
    if (sidecar.range) {
      numbers.emplace_back("R16 range min", format_number(sidecar.range->low_m));
      numbers.emplace_back("R16 range max", format_number(sidecar.range->high_m));
      numbers.emplace_back("R16 size", std::to_string(frame.width) + " x " + std::to_string(frame.height));
    }
    return numbers;
  }
  // A picture's UVs run from pixel edge to pixel edge, so the plane is as large as the cells, not as the samples.
  return {{"plane size X", format_number(tidy(frame.width_m()))},
          {"plane size Y", format_number(tidy(frame.height_m()))},
          {"plane subdivisions X", std::to_string(frame.width)},
          {"plane subdivisions Y", std::to_string(frame.height)},
          {"image colour space", "Non-Color"},
          {"texture Clamp", "off"},
          {"texture extension", "Clip"},
          {"texture crop maximum X, Y", "0.99999"},
          {"Displace coordinates", "UV"},
          {"Displace direction", "Z"},
          {"Displace strength", "1"},
          {"Displace midlevel", "0"}};
}

}  // namespace

const std::vector<int>& engine_sizes(Engine engine) {
  static const std::vector<int> kUnreal = {127, 253, 505, 1009, 2017, 4033, 8129};
  static const std::vector<int> kUnity = {33, 65, 129, 257, 513, 1025, 2049, 4097};
  static const std::vector<int> kAny;
  return engine == Engine::unreal ? kUnreal : engine == Engine::unity ? kUnity : kAny;
}

void check_engine_path(const std::string& path, Engine engine, bool heights) {
  static const std::vector<std::vector<std::string>> kExtensions = {
      {".r16", ".raw", ".png"}, {".raw", ".r16"}, {".exr", ".r16"}, {".exr"}};
  const auto& known = kExtensions[static_cast<size_t>(engine)];
  const std::string extension = extension_of(path);
  if (!heights) {
    if (extension != ".png")
      throw InvalidArgument("path", "masks go to engines as .png of 8 bits, not as '" + extension + "'");
    return;
  }
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw InvalidArgument("path", "'" + extension + "' is not a format that " +
                                      std::string(Choices<Engine>::names[static_cast<size_t>(engine)]) + " reads" +
                                      suggestion(extension, known));
}

Sidecar engine_sidecar(const GridFrame& frame, HeightRange extremes, Engine engine, const std::string& path,
                       const EngineOptions& options) {
  check_engine_path(path, engine);
  Sidecar sidecar;
  sidecar.frame = frame;
  sidecar.min_m = extremes.low_m;
  sidecar.max_m = extremes.high_m;
  sidecar.target = Choices<Engine>::names[static_cast<size_t>(engine)];
  sidecar.provenance = options.provenance;
  if (extension_of(path) == ".exr") {
    sidecar.import = metric_numbers(engine, frame, sidecar);
    return sidecar;
  }
  if (options.range) check_range(extremes, *options.range);
  const UnrealScale scale = unreal_scale(extremes, options);
  sidecar.range = engine == Engine::unreal ? scale.range() : plain_range(extremes, options);
  check_range(extremes, *sidecar.range);
  sidecar.import = engine == Engine::unreal  ? unreal_numbers(frame, scale)
                   : engine == Engine::unity ? unity_numbers(frame, *sidecar.range)
                                             : metric_numbers(engine, frame, sidecar);
  sidecar.south_first = engine == Engine::unity;
  return sidecar;
}

void write_engine_samples(const HeightField& heights, Engine engine, const Sidecar& sidecar, const std::string& path) {
  if (!sidecar.range) {
    const char* channel = engine == Engine::godot ? "R" : "Y";
    write_atomically(path, [&](const std::string& temporary) { encode_exr(heights, temporary, path, channel); });
  } else {
    Grid<uint16_t> codes = to_codes(heights, *sidecar.range);
    for (int y = 0; sidecar.south_first && y < codes.height() / 2; ++y)
      std::swap_ranges(codes.row(y).begin(), codes.row(y).end(), codes.row(codes.height() - 1 - y).begin());
    write_codes(codes, path);
  }
  write_sidecar(sidecar, path);
}

void write_for_engine(const HeightField& heights, Engine engine, const std::string& path,
                      const EngineOptions& options) {
  check_engine_path(path, engine);
  const HeightRange extremes = finite_range(heights);
  check_size(heights, engine);
  write_engine_samples(heights, engine, engine_sidecar(heights.frame(), extremes, engine, path, options), path);
}

}  // namespace seamount::io

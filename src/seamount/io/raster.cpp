#include "seamount/io/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/image_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster_files.h"
#include "seamount/io/vertical_unit.h"
#include "seamount/io/void_codes.h"
#include "seamount/io/warp.h"

namespace seamount::io {
namespace {

bool is_gdal_format(const std::string& extension) {
  return extension == ".tif" || extension == ".tiff" || extension == ".hgt" || extension == ".asc";
}

[[noreturn]] void refuse_extension(const std::string& path, const std::vector<std::string>& known) {
  const std::string extension = extension_of(path);
  throw IoError(path, "'" + extension + "' is not a raster format" + suggestion(extension, known));
}

/// What a format cannot heed is an error, not ignored.
void refuse_options(const std::string& name, const ReadOptions& options) {
  const std::string extension = extension_of(name);
  const bool gdal = is_gdal_format(extension), png = extension == ".png";
  const auto refuse = [&](const char* option, bool given, const char* what) {
    if (given) throw InvalidArgument(option, std::string("is for ") + what + ", not for '" + name + "'");
  };
  refuse("coding", options.coding != ElevationCoding::numbers && !gdal && !png, "GeoTIFF and PNG");
  refuse("band", options.band.value_or(1) != 1 && !gdal && !png, "GeoTIFF and PNG");
  refuse("byte_order", options.byte_order == ByteOrder::big && extension != ".r16" && extension != ".raw",
         "raw files of 16 bits");
  refuse("unit", !options.unit.empty() && options.coding != ElevationCoding::numbers,
         "heights that are no colours, which are metres");
}

Stored decode(std::span<const uint8_t> bytes, const std::string& name, const ReadOptions& options,
              const std::optional<Sidecar>& sidecar, Meaning meaning) {
  const std::string extension = extension_of(name);
  if (bytes.empty()) throw IoError(name, "is empty");
  if (extension == ".npy") return decode_npy(bytes, name, options.max_cells);
  if (extension == ".exr") return decode_exr(bytes, name, options.max_cells);
  if (extension == ".png") return decode_png_heights(bytes, name, options);
  if (is_gdal_format(extension)) {
    const MemoryFile memory(bytes, name);
    return read_gdal(memory.path(), name, options, meaning == Meaning::heights);
  }
  if (extension != ".r16" && extension != ".raw" && extension != ".r32")
    refuse_extension(name, readable_raster_extensions());
  std::optional<std::pair<int, int>> size;
  if (sidecar) size = std::pair(sidecar->frame.width, sidecar->frame.height);
  return decode_raw(bytes, name, options, size);
}

void flip_rows(Grid<float>& grid) {
  for (int y = 0; y < grid.height() / 2; ++y)
    std::swap_ranges(grid.row(y).begin(), grid.row(y).end(), grid.row(grid.height() - 1 - y).begin());
}

int64_t voids_of(const Grid<float>& grid) {
  return std::count_if(grid.cells().begin(), grid.cells().end(), [](float z) { return std::isnan(z); });
}

void warp(Stored& stored, const std::string& name, const Settlement& settlement, const GdalCall& call,
          const ReadOptions& options) {
  const bool fits = options.lattice && options.lattice->crs == settlement.crs;
  Warped warped = warp_to_metres(stored.values, *stored.placement, settlement,
                                 {options.cover, fits ? &*options.lattice : nullptr, options.max_cells}, call,
                                 options.run.part(0.5, 0.9));
  stored.values = std::move(warped.raster);
  if (warped.turned)
    options.run.say(name + ": is turned against north; the corners of the upright raster lie beyond it, " +
                    std::to_string(voids_of(stored.values)) + " of " + std::to_string(stored.values.size()) +
                    " cells have no value");
}

/// A stored raster with a placement on square cells in metres.
void settle_stored(Stored& stored, const std::string& name, const ReadOptions& options, Meaning meaning) {
  const GdalCall call(name);
  choose_system(stored, name, options, meaning);
  const Placement& p = *stored.placement;
  Grid<float>& grid = stored.values;
  Settlement settlement = settle(p, grid.width(), grid.height(), call);
  if (!settlement.note.empty()) options.run.say(name + ": " + settlement.note);
  if (!settlement.as_it_is && !settlement.crs.empty() && !options.into.empty()) settlement.crs = options.into;
  if (settlement.as_it_is)
    grid.set_frame({grid.width(), grid.height(), p.cell_x, p.west, p.north, stored.crs});
  else
    warp(stored, name, settlement, call, options);
}

void place(Stored& stored, const std::string& name, const ReadOptions& options, const std::optional<Sidecar>& sidecar,
           Meaning meaning) {
  Grid<float>& grid = stored.values;
  if (sidecar) {
    if (sidecar->frame.width != grid.width() || sidecar->frame.height != grid.height())
      throw IoError(name, "is " + std::to_string(grid.width()) + " x " + std::to_string(grid.height()) +
                              ", its side-car '" + sidecar_path(name) + "' says " +
                              std::to_string(sidecar->frame.width) + " x " + std::to_string(sidecar->frame.height));
    GridFrame frame = sidecar->frame;
    if (!options.crs.empty()) frame.crs = options.crs == "local" ? "" : metric_crs(options.crs);
    grid.set_frame(frame);
    if (sidecar->south_first) flip_rows(grid);
  } else if (stored.placement) {
    settle_stored(stored, name, options, meaning);
  } else {
    if (!options.cell_m) throw IoError(name, "does not say its cell size; give cell_m");
    if (!(*options.cell_m > 0) || !std::isfinite(*options.cell_m))
      throw InvalidArgument("cell_m", format_number(*options.cell_m) + " is not above 0");
    grid.set_frame(GridFrame::centred(grid.width(), grid.height(), *options.cell_m));
    if (!options.crs.empty() && options.crs != "local")
      throw InvalidArgument("crs", name + " does not say where it lies in '" + options.crs + "'");
    return;
  }
  if (options.cell_m && std::abs(*options.cell_m / grid.cell_m() - 1) > 1e-6)
    say_own_cells(name, grid.cell_m(), *options.cell_m, options.run);
}

/// Codes to heights. A range given for real values maps 0..1, which is what other tools export.
void apply_range(Stored& stored, const std::string& name, const ReadOptions& options,
                 const std::optional<Sidecar>& sidecar, Meaning meaning) {
  std::optional<HeightRange> range = options.range;
  if (!range && sidecar && stored.code_max > 0) range = sidecar->range;
  if (!range && stored.code_max > 0 && meaning == Meaning::mask) range = HeightRange{0.0, 1.0};
  if (!range && stored.code_max > 0 && meaning == Meaning::heights && !stored.placement)
    throw IoError(name, "its " + stored.type + " codes say nothing of metres; give the heights of codes 0 and " +
                            format_number(stored.code_max) + " (low_m, high_m) or the side-car '" + sidecar_path(name) +
                            "'");
  if (!range) return;
  if (!std::isfinite(range->low_m) || !std::isfinite(range->high_m) || !(range->high_m > range->low_m))
    throw InvalidArgument("range", "low_m must be below high_m");
  const double scale = (range->high_m - range->low_m) / (stored.code_max > 0 ? stored.code_max : 1.0);
  for (float& z : stored.values.cells()) z = static_cast<float>(range->low_m + z * scale);
}

/// What can be done before the place is known.
void prepare(Stored& stored, const std::string& name, const ReadOptions& options, Meaning meaning) {
  if (stored.code_max > 0) {
    if (!options.unit.empty())
      throw InvalidArgument("unit", "'" + name + "' holds codes; low_m and high_m say which metres they stand for");
    return;
  }
  const bool heights = meaning == Meaning::heights;
  Grid<float>& values = stored.values;
  if (!stored.ours) take_out_void_codes(values, name, heights, options.run);
  for (float& z : values.cells())
    if (std::isinf(z)) z = std::numeric_limits<float>::quiet_NaN();
  if (stored.metres || !heights || options.unit.empty()) return;
  const auto unit = metres_in_unit(options.unit);
  if (!unit) throw InvalidArgument("unit", "'" + options.unit + "' is no unit of length that is known");
  for (float& z : values.cells()) z = static_cast<float>(z * *unit);
}

Grid<float> read(const std::string& path, const ReadOptions& options, Meaning meaning) {
  return finish_raster(load_raster(path, options, meaning), path, options, meaning);
}

Sidecar sidecar_of(const Grid<float>& grid, const WriteOptions& options, bool heights) {
  const HeightRange extremes = known_range(grid);
  Sidecar sidecar;
  sidecar.frame = grid.frame();
  sidecar.min_m = extremes.low_m;
  sidecar.max_m = extremes.high_m;
  sidecar.heights = heights;
  sidecar.ground_width = options.ground_width;
  sidecar.ground_height = options.ground_height;
  sidecar.provenance = options.provenance;
  return sidecar;
}

/// Writes the side-car, or removes the one that described the earlier file.
void finish_sidecar(const Sidecar& sidecar, const std::string& path, const WriteOptions& options) {
  if (options.sidecar) return write_sidecar(sidecar, path);
  std::error_code none_there;
  std::filesystem::remove(sidecar_path(path), none_there);
}

void write(const Grid<float>& grid, const std::string& path, const WriteOptions& options, bool heights) {
  const std::string extension = extension_of(path);
  Sidecar sidecar = sidecar_of(grid, options, heights);
  if (extension == ".tif" || extension == ".tiff") return write_geotiff(grid, path, options, heights);
  if (extension == ".asc") return write_asc(grid, path);
  if (extension == ".exr") {
    write_atomically(path, [&](const std::string& temporary) { encode_exr(grid, temporary, path); });
  } else if (extension == ".npy") {
    write_atomically(path, [&](const std::string& temporary) { encode_npy(grid, temporary, path); });
  } else if (extension == ".r32") {
    write_bytes(path, {reinterpret_cast<const uint8_t*>(grid.data()), grid.size() * sizeof(float)});
  } else if (extension == ".png" || extension == ".r16" || extension == ".raw") {
    sidecar.range = coding_range(grid, options.range);
    if (options.range) finite_range(grid);  // codes have none for what is not known
    write_codes(to_codes(grid, *sidecar.range), path);
  } else {
    refuse_extension(path, writable_raster_extensions());
  }
  finish_sidecar(sidecar, path, options);
}

/// Painted row by row: the picture of a large map is never in memory.
std::vector<uint8_t> encode_label_rows(const LabelMap& labels) {
  std::array<Colour, kRegionCount> colours;
  for (const Region region : kRegions) colours[static_cast<size_t>(region)] = painted_colour(region);
  return encode_png_rows(labels.width(), labels.height(), 3, [&](int y, std::span<uint8_t> row) {
    for (int x = 0; x < labels.width(); ++x) {
      const Colour colour = colours[static_cast<size_t>(labels(x, y))];
      const auto i = 3 * static_cast<size_t>(x);
      row[i] = colour.r;
      row[i + 1] = colour.g;
      row[i + 2] = colour.b;
    }
  });
}

}  // namespace

Loaded load_raster(const std::string& path, const ReadOptions& options, Meaning meaning) {
  check_readable(path);
  refuse_options(path, options);
  if (is_gdal_format(extension_of(path)))
    return {read_gdal(path, path, options, meaning == Meaning::heights), std::nullopt};
  const std::vector<uint8_t> bytes = read_file(path);
  std::optional<Sidecar> sidecar = read_sidecar(path, bytes);
  Stored stored = decode(bytes, path, options, sidecar, meaning);
  stored.ours = sidecar && sidecar->ours;
  prepare(stored, path, options, meaning);
  return {std::move(stored), std::move(sidecar)};
}

Grid<float> finish_raster(Loaded loaded, const std::string& name, const ReadOptions& options, Meaning meaning) {
  Stored& stored = loaded.stored;
  const bool heights = meaning == Meaning::heights && !stored.ours;
  const bool metres = heights && stored.code_max == 0 && !options.range;
  if (metres) take_out_impossible_heights(stored.values, name, options.run);
  say_voids(voids_of(stored.values), static_cast<int64_t>(stored.values.size()), name, options.run);
  place(stored, name, options, loaded.sidecar, meaning);
  apply_range(stored, name, options, loaded.sidecar, meaning);
  if (heights && !metres) take_out_impossible_heights(stored.values, name, options.run);
  options.run.check_cancelled();
  return std::move(stored.values);
}

const std::vector<std::string>& readable_raster_extensions() {
  static const std::vector<std::string> kExtensions = {".tif", ".tiff", ".hgt", ".asc", ".png",
                                                       ".exr", ".r16",  ".raw", ".r32", ".npy"};
  return kExtensions;
}

const std::vector<std::string>& writable_raster_extensions() {
  static const std::vector<std::string> kExtensions = {".tif", ".tiff", ".asc", ".png", ".exr",
                                                       ".r16", ".raw",  ".r32", ".npy"};
  return kExtensions;
}

bool can_hold_voids(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension != ".png" && extension != ".r16" && extension != ".raw";
}

std::vector<std::string> written_files(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".tif" || extension == ".tiff") return {path};
  if (extension == ".asc") return {path, path.substr(0, path.size() - extension.size()) + ".prj"};
  return {path, sidecar_path(path)};
}

void count_values(const Grid<float>& grid, RasterInfo& info) {
  bool any = false;
  for (const float z : grid.cells()) {
    if (!std::isfinite(z)) {
      ++info.void_cells;
      continue;
    }
    info.min = any ? std::min<double>(info.min, z) : z;
    info.max = any ? std::max<double>(info.max, z) : z;
    any = true;
  }
}

RasterInfo raster_info(const std::string& path) {
  check_readable(path);
  if (is_gdal_format(extension_of(path))) return gdal_info(path);
  const std::vector<uint8_t> bytes = read_file(path);
  const std::optional<Sidecar> sidecar = read_sidecar(path, bytes);
  const Stored stored = decode(bytes, path, ReadOptions{}, sidecar, Meaning::field);
  RasterInfo info;
  info.width = stored.values.width();
  info.height = stored.values.height();
  info.format = stored.format;
  info.type = stored.type;
  if (sidecar) {
    info.cell_x = info.cell_y = sidecar->frame.cell_m;
    info.crs = sidecar->frame.crs;
  }
  count_values(stored.values, info);
  return info;
}

HeightField read_heights(const std::string& path, const ReadOptions& options) {
  return read(path, options, Meaning::heights);
}

HeightField read_heights(std::span<const uint8_t> bytes, const std::string& name, const ReadOptions& options) {
  Stored stored = decode(bytes, name, options, std::nullopt, Meaning::heights);
  prepare(stored, name, options, Meaning::heights);
  return finish_raster({std::move(stored), std::nullopt}, name, options, Meaning::heights);
}

ScalarField read_field(const std::string& path, const ReadOptions& options) {
  return read(path, options, Meaning::field);
}

Mask read_mask(const std::string& path, const ReadOptions& options) { return read(path, options, Meaning::mask); }

PlacedImage read_placed_image(const std::string& path, const ReadOptions& options) {
  const std::vector<uint8_t> bytes = read_file(path);
  const std::optional<Sidecar> sidecar = read_sidecar(path, bytes);
  Image image = read_image(bytes, path);
  Stored size{Grid<float>(GridFrame{image.width, image.height}), 0.0, "PNG", "uint8"};
  place(size, path, options, sidecar, Meaning::field);
  return {std::move(image), size.values.frame()};
}

LabelMap read_labels(const std::string& path, const ReadOptions& options) {
  const Grid<float> numbers = read(path, options, Meaning::field);
  LabelMap labels(numbers.frame());
  for (size_t i = 0; i < numbers.size(); ++i) {
    const float number = numbers.cells()[i];
    if (!(number >= 0 && number < kRegionCount && number == std::floor(number)))
      throw IoError(path, "label " + format_number(number) + " is not one of 0 (mountain) to 4 (abyss)");
    labels.cells()[i] = static_cast<Region>(number);
  }
  return labels;
}

void write_heights(const HeightField& heights, const std::string& path, const WriteOptions& options) {
  write(heights, path, options, true);
}

void write_field(const ScalarField& field, const std::string& path, const WriteOptions& options) {
  write(field, path, options, false);
}

void write_mask(const Mask& mask, const std::string& path, const WriteOptions& options) {
  const std::string extension = extension_of(path);
  const bool tiff = extension == ".tif" || extension == ".tiff";
  if (!tiff && extension != ".png") return write_field(mask, path, options);
  Sidecar sidecar = sidecar_of(mask, options, false);
  finite_range(mask);
  Grid<uint8_t> bytes(mask.frame());
  for (size_t i = 0; i < bytes.size(); ++i)
    bytes.cells()[i] = static_cast<uint8_t>(std::clamp(mask.cells()[i], 0.0F, 1.0F) * 255.0F + 0.5F);
  if (tiff) return write_geotiff8(bytes, path, options, false);
  write_bytes(path, encode_png8(bytes.cells(), mask.width(), mask.height(), 1));
  sidecar.range = HeightRange{0.0, 1.0};
  finish_sidecar(sidecar, path, options);
}

void write_labels(const LabelMap& labels, const std::string& path, const WriteOptions& options) {
  if (labels.empty()) throw InvalidArgument("labels", "there are no cells");
  const std::string extension = extension_of(path);
  if (extension == ".png") {
    write_bytes(path, encode_label_rows(labels));
    Sidecar sidecar;
    sidecar.frame = labels.frame();
    sidecar.max_m = kRegionCount - 1;
    sidecar.heights = false;
    sidecar.for_painting = true;
    sidecar.provenance = options.provenance;
    finish_sidecar(sidecar, path, options);
    return;
  }
  if (extension != ".tif" && extension != ".tiff") refuse_extension(path, {".tif", ".png"});
  Grid<uint8_t> numbers(labels.frame());
  std::transform(labels.cells().begin(), labels.cells().end(), numbers.cells().begin(),
                 [](Region region) { return static_cast<uint8_t>(region); });
  write_geotiff8(numbers, path, options, true);
}

}  // namespace seamount::io

#include "seamount/io/info.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/label_info.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster.h"
#include "seamount/io/sidecar.h"

namespace seamount::io {
namespace {

bool has_extension(const std::string& path, const std::vector<std::string>& extensions) {
  return std::find(extensions.begin(), extensions.end(), extension_of(path)) != extensions.end();
}

bool is_colour_picture(const std::string& path) {
  return has_extension(path, {".jpg", ".jpeg"}) ||
         (extension_of(path) == ".png" && png_header(read_file(path), path).channels > 2);
}

/// To a hundredth of a millimetre.
std::string rounded(double value) { return format_number(std::round(value * 1e5) / 1e5); }

std::string metres_between(double low, double high) { return short_number(low) + " m to " + short_number(high) + " m"; }

void describe_place(FileInfo& info, double cell_m, int width, int height, const std::string& crs) {
  info.emplace_back("cell", short_number(cell_m) + " m");
  info.emplace_back("extent", short_number(cell_m * width) + " m x " + short_number(cell_m * height) + " m");
  info.emplace_back("coordinate system", crs.empty() ? "none (local metres)" : crs_name(crs));
}

void describe_sidecar(FileInfo& info, const Sidecar& sidecar) {
  describe_place(info, sidecar.frame.cell_m, sidecar.frame.width, sidecar.frame.height, sidecar.frame.crs);
  if (sidecar.heights) info.emplace_back("heights", metres_between(sidecar.min_m, sidecar.max_m));
  if (!sidecar.heights) info.emplace_back("values", short_number(sidecar.min_m) + " to " + short_number(sidecar.max_m));
  if (sidecar.range)
    info.emplace_back("codes stand for", rounded(sidecar.range->low_m) + " to " + rounded(sidecar.range->high_m) +
                                             (sidecar.heights ? " m" : ""));
  if (sidecar.ground_width > 0)
    info.emplace_back("ground", std::to_string(sidecar.ground_width) + " x " + std::to_string(sidecar.ground_height) +
                                    " samples; the others repeat its edge");
  info.emplace_back("first row", sidecar.south_first ? "south" : "north");
  if (!sidecar.target.empty()) info.emplace_back("made for", sidecar.target);
  for (const auto& [place, value] : sidecar.import) info.emplace_back("  " + place, value);
  if (!sidecar.provenance.program.empty()) info.emplace_back("made by", sidecar.provenance.program);
  if (!sidecar.provenance.recipe.empty()) info.emplace_back("recipe", sidecar.provenance.recipe);
  if (sidecar.provenance.seed) info.emplace_back("seed", std::to_string(*sidecar.provenance.seed));
}

/// "mountain", "12.3 %" and so on.
void describe_regions(FileInfo& info, const RegionCounts& counts) {
  int64_t all = counts.others;
  for (const int64_t cells : counts.cells) all += cells;
  const auto share = [&](int64_t cells) {
    const double percent = 100.0 * static_cast<double>(cells) / static_cast<double>(std::max<int64_t>(1, all));
    return (cells > 0 && percent < 0.1 ? "below 0.1" : format_number(std::round(10.0 * percent) / 10.0)) + " %";
  };
  for (const Region region : kRegions)
    info.emplace_back(region_name(region), share(counts.cells[static_cast<size_t>(region)]));
  if (counts.others > 0) info.emplace_back("no region", share(counts.others));
}

void describe_cells(FileInfo& info, const std::string& path) {
  const RasterInfo raster = raster_info(path);
  info.emplace_back("format", raster.format + ", " + raster.type);
  info.emplace_back("size", std::to_string(raster.width) + " x " + std::to_string(raster.height));
  if (raster.bands > 1) info.emplace_back("bands", std::to_string(raster.bands));
  if (const std::optional<Sidecar> sidecar = read_sidecar(path)) return describe_sidecar(info, *sidecar);
  if (raster.geographic) {
    info.emplace_back("cell", short_number(raster.cell_x) + " x " + short_number(raster.cell_y) + " degrees");
    info.emplace_back("coordinate system", crs_name(raster.crs));
  } else if (raster.cell_x > 0) {
    describe_place(info, raster.cell_x, raster.width, raster.height, raster.crs);
  } else {
    info.emplace_back("cell", "not stated");
  }
  const bool real = raster.cell_x > 0 || raster.type.starts_with("float");
  info.emplace_back(real ? "values" : "codes", short_number(raster.min) + " to " + short_number(raster.max));
  if (raster.nodata) info.emplace_back("no-data value", short_number(*raster.nodata));
  if (raster.void_cells > 0) info.emplace_back("cells without value", std::to_string(raster.void_cells));
  for (const std::string& note : raster.notes) info.emplace_back("note", note);
}

}  // namespace

std::string short_number(double value) {
  if (value == 0 || !std::isfinite(value)) return format_number(value);
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return format_number(unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value));
}

std::optional<FileInfo> describe_raster(const std::string& path) {
  if (!has_extension(path, readable_raster_extensions()) || is_colour_picture(path)) return std::nullopt;
  FileInfo info;
  describe_cells(info, path);
  if (!has_extension(path, {".tif", ".tiff"})) return info;
  if (const auto counts = count_regions(path)) describe_regions(info, *counts);
  return info;
}

std::optional<FileInfo> describe_picture(const std::string& path) {
  if (!has_extension(path, {".jpg", ".jpeg", ".png"}) || !is_colour_picture(path)) return std::nullopt;
  const Image image = read_image(path);
  FileInfo info{{"format", "picture"}, {"size", std::to_string(image.width) + " x " + std::to_string(image.height)}};
  const auto counts = count_regions(image);
  if (!counts) return info;
  info[0].second = "regions as a picture";
  if (const std::optional<Sidecar> sidecar = read_sidecar(path)) {
    const GridFrame& frame = sidecar->frame;
    describe_place(info, frame.cell_m, frame.width, frame.height, frame.crs);
  }
  describe_regions(info, *counts);
  return info;
}

}  // namespace seamount::io

#include "seamount/io/large_raster.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_band.h"
#include "seamount/io/raster_files.h"
#include "seamount/io/void_codes.h"
#include "seamount/io/warp.h"
#include "seamount/io/warp_window.h"

namespace seamount::io {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr int64_t kAtOnce = int64_t{1} << 23;  ///< cells

/// Cells of a file, as stored.
struct Box {
  int column = 0, row = 0, width = 0, height = 0;
};

/// Visits boxes that fill a box and end where the file's blocks do: no block is unpacked twice without need.
template <class Visit>
void for_each_box(const Box& all, int block_x, int block_y, const Visit& visit) {
  const auto end_of = [](int64_t from, int64_t wanted, int block, int last) {
    const int64_t end = (from + wanted) / block * block;
    return static_cast<int>(std::min<int64_t>(end > from ? end : (from / block + 1) * block, last));
  };
  const int right = all.column + all.width, bottom = all.row + all.height;
  const int64_t columns = std::max<int64_t>(block_x, kAtOnce / std::max(block_y, 1024));
  for (int row = all.row; row < bottom;) {
    const int64_t rows = std::max<int64_t>(1, kAtOnce / std::min<int64_t>(columns, all.width));
    const int row_end = end_of(row, rows, block_y, bottom);
    for (int column = all.column; column < right;) {
      const int column_end = end_of(column, columns, block_x, right);
      visit(Box{column, row, column_end - column, row_end - row});
      column = column_end;
    }
    row = row_end;
  }
}

}  // namespace

struct LargeRaster::File {
  std::string path;
  std::optional<int> band;
  int width = 0, height = 0, block_x = 1, block_y = 1;
  Flips flips;
  Placement placement;
  double scale = 1.0, offset = 0.0;
  bool ours = false, local = false;
  std::string crs;
  double relief = 0.0;
  VoidCodes codes{true};
  ImpossibleHeights impossible;
  bool warped = false;  ///< to other cells than are stored
  GridFrame frame;

  float height_of(float stored) const {
    return scale == 1.0 && offset == 0.0 ? stored : static_cast<float>(stored * scale + offset);
  }
  void open(const ReadOptions& options);
  int64_t look(const RunContext& run);
  void settle(const ReadOptions& options);
  /// Cells as stored, row 0 north; NaN where the file says that there is none.
  Grid<float> raw(GDALDataset& dataset, const Box& box, const GdalCall& call) const;
  Grid<float> heights(GDALDataset& dataset, const Box& box, const GdalCall& call, const RunContext& run) const;
  GDALRasterBand& band_of(GDALDataset& dataset) const { return *dataset.GetRasterBand(band.value_or(1)); }
};

namespace {

void check_kind(GDALDataset& dataset, GDALRasterBand& band, const ReadOptions& options, const std::string& path) {
  const GDALDataType type = band.GetRasterDataType();
  const bool no_unit = options.unit.empty() && std::strlen(band.GetUnitType()) == 0 && band.GetScale() == 1.0;
  if ((type == GDT_Byte || type == GDT_UInt16) && no_unit)
    throw IoError(path, "is too large to be read as a whole, as codes of " + type_name(type) +
                            " are; if they are heights, state their unit (\"unit\": \"m\")");
  Flips flips;
  const GdalCall call(path);
  if (!placement_of(dataset, flips, call))
    throw IoError(path, "is too large to be read as a whole, as what does not say where it lies is");
}

}  // namespace

void LargeRaster::File::open(const ReadOptions& options) {
  const GdalCall call(path);
  const DatasetPtr dataset = open_raster(call, path);
  GDALRasterBand& found = checked_band(*dataset, options.band, true, call);
  check_kind(*dataset, found, options, path);
  band = options.band;
  width = dataset->GetRasterXSize();
  height = dataset->GetRasterYSize();
  found.GetBlockSize(&block_x, &block_y);
  placement = *placement_of(*dataset, flips, call);
  ours = is_ours(*dataset);
  local = is_local(*dataset);
  crs = kept_crs(*dataset, placement.system);
  const double unit = height_unit(*dataset, found, options, call);
  scale = found.GetScale() * unit;
  offset = found.GetOffset() * unit;
}

Grid<float> LargeRaster::File::raw(GDALDataset& dataset, const Box& box, const GdalCall& call) const {
  GDALRasterBand& values = band_of(dataset);
  const bool masked = (values.GetMaskFlags() & GMF_ALL_VALID) == 0;
  Grid<float> grid(GridFrame{box.width, box.height});
  const int left = flips.east_first ? width - box.column - box.width : box.column;
  const int top = flips.south_up ? height - box.row - box.height : box.row;
  std::vector<uint8_t> mask;
  for_each_box({left, top, box.width, box.height}, block_x, block_y, [&](const Box& part) {
    float* to = &grid(part.column - left, part.row - top);
    const auto line = static_cast<GSpacing>(sizeof(float)) * box.width;
    if (values.RasterIO(GF_Read, part.column, part.row, part.width, part.height, to, part.width, part.height,
                        GDT_Float32, sizeof(float), line, nullptr) != CE_None)
      call.fail("is truncated or damaged in or after row " + std::to_string(part.row));
    if (!masked) return;
    mask.resize(static_cast<size_t>(part.width) * static_cast<size_t>(part.height));
    if (values.GetMaskBand()->RasterIO(GF_Read, part.column, part.row, part.width, part.height, mask.data(), part.width,
                                       part.height, GDT_Byte, 0, 0, nullptr) != CE_None)
      call.fail("its mask is damaged in or after row " + std::to_string(part.row));
    for (int y = 0; y < part.height; ++y) {
      for (int x = 0; x < part.width; ++x)
        if (mask[static_cast<size_t>(y) * static_cast<size_t>(part.width) + static_cast<size_t>(x)] == 0)
          grid(part.column - left + x, part.row - top + y) = kNone;
    }
  });
  if (flips.south_up) {
    for (int y = 0; y < box.height / 2; ++y)
      std::swap_ranges(grid.row(y).begin(), grid.row(y).end(), grid.row(box.height - 1 - y).begin());
  }
  if (flips.east_first) {
    for (int y = 0; y < box.height; ++y) std::reverse(grid.row(y).begin(), grid.row(y).end());
  }
  return grid;
}

Grid<float> LargeRaster::File::heights(GDALDataset& dataset, const Box& box, const GdalCall& call,
                                       const RunContext& run) const {
  run.check_cancelled();
  Grid<float> grid = raw(dataset, box, call);
  codes.take_out(grid.cells());
  for (float& z : grid.cells()) z = height_of(z);
  impossible.take_out(grid.cells());
  return grid;
}

/// Counts what may be no height, which the cells are cleaned of from then on. Returns how many have none.
int64_t LargeRaster::File::look(const RunContext& run) {
  const GdalCall call(path);
  const DatasetPtr dataset = open_raster(call, path);
  const bool may_be_codes = !ours && band_of(*dataset).GetRasterDataType() != GDT_Byte;
  VoidCodes seen(true);
  ImpossibleHeights judged;
  int64_t unknown = 0;
  for_each_box({0, 0, width, height}, block_x, block_y, [&](const Box& box) {
    run.check_cancelled();
    const Grid<float> part = raw(*dataset, box, call);
    if (may_be_codes) seen.look(part.cells());
    for (const float stored : part.cells()) {
      if (std::isnan(stored)) {
        ++unknown;
      } else if (!may_be_codes || !VoidCodes::candidate(stored)) {
        judged.look(height_of(stored));
      }
    }
    run.report(static_cast<double>(box.row + box.height) / height);
  });
  seen.settle();
  seen.each_kept([&](float stored, int64_t cells) { judged.look(height_of(stored), cells); });
  codes = seen;
  relief = judged.relief();
  if (!ours) impossible = judged;
  return unknown + codes.count() + impossible.count();
}

/// Where it lies: as read_heights() finds it.
void LargeRaster::File::settle(const ReadOptions& options) {
  const GdalCall call(path);
  if (!options.crs.empty()) {
    placement.system = OGRSpatialReference();
    if (options.crs != "local") placement.system = *parse_crs(options.crs);
    crs = options.crs == "local" ? "" : crs_text(&placement.system);
  } else if (!local && must_be_degrees(placement, width, height, relief, true)) {
    placement.system = lonlat_system();
    say_degrees(path, options.run);
  }
  Settlement settlement = io::settle(placement, width, height, call);
  if (!settlement.note.empty()) options.run.say(path + ": " + settlement.note);
  if (settlement.as_it_is) {
    frame = {width, height, placement.cell_x, placement.west, placement.north, crs};
    return;
  }
  warped = true;
  if (!settlement.crs.empty() && !options.into.empty()) settlement.crs = options.into;
  bool turned = false;
  constexpr int64_t kMostCells = int64_t{1} << 32;
  frame = warped_frame(placement, width, height, settlement, {options.cover, nullptr, kMostCells}, call, turned);
  if (turned) options.run.say(path + ": is turned against north; the corners of the upright raster lie beyond it");
}

LargeRaster::LargeRaster(std::string path, const ReadOptions& options) {
  check_readable(path);
  auto file = std::make_unique<File>();
  file->path = std::move(path);
  file->open(options);
  const int64_t unknown = file->look(options.run);
  file->codes.say(file->path, options.run);
  file->impossible.settle(file->path, options.run);
  say_voids(unknown, int64_t{file->width} * file->height, file->path, options.run);
  file->settle(options);
  if (options.cell_m && std::abs(*options.cell_m / file->frame.cell_m - 1) > 1e-6)
    say_own_cells(file->path, file->frame.cell_m, *options.cell_m, options.run);
  file_ = std::move(file);
}

LargeRaster::~LargeRaster() = default;

const GridFrame& LargeRaster::frame() const { return file_->frame; }

HeightField LargeRaster::read(const GridFrame& window, const RunContext& run) const {
  const File& file = *file_;
  const GdalCall call(file.path);
  const DatasetPtr dataset = open_raster(call, file.path);
  if (file.warped) {
    const auto read = [&](int column, int row, int width, int height) {
      return file.heights(*dataset, {column, row, width, height}, call, run);
    };
    return warp_window(window, {file.placement, file.width, file.height, read}, call, run);
  }
  HeightField out =
      file.heights(*dataset, {window.first_column(), window.first_row(), window.width, window.height}, call, run);
  out.set_frame(window);
  return out;
}

std::pair<int, int> stored_size(const std::string& path) {
  check_readable(path);
  const GdalCall call(path);
  const DatasetPtr dataset = open_raster(call, path);
  return {dataset->GetRasterXSize(), dataset->GetRasterYSize()};
}

}  // namespace seamount::io

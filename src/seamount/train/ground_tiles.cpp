#include "seamount/train/ground_tiles.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/rng.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/io/raster.h"

namespace seamount::train {
namespace {

constexpr int kLevelRun = 24;  ///< cells of one height in a row and a column that are water

bool shows_land(const std::string& name) {
  for (const std::string_view sea : {"bathy", "reef_", "gebco", "etopo"}) {
    if (name.find(sea) != std::string::npos) return false;
  }
  return true;
}

/// Cells in runs of one height along a row.
void mark_level_rows(const HeightField& heights, Grid<uint8_t>& level, uint8_t bit, bool columns) {
  const int lines = columns ? heights.width() : heights.height(), length = columns ? heights.height() : heights.width();
  const auto at = [&](int line, int i) { return columns ? heights(line, i) : heights(i, line); };
  for (int line = 0; line < lines; ++line) {
    for (int begin = 0; begin < length;) {
      int end = begin + 1;
      while (end < length && std::abs(at(line, end) - at(line, begin)) < 0.05F) ++end;
      for (int i = begin; end - begin >= kLevelRun && i < end; ++i) (columns ? level(line, i) : level(i, line)) |= bit;
      begin = end;
    }
  }
}

void forget_level_water(HeightField& heights) {
  Grid<uint8_t> level(heights.frame(), 0);
  mark_level_rows(heights, level, 1, false);
  mark_level_rows(heights, level, 2, true);
  for (size_t i = 0; i < heights.size(); ++i) {
    if (level.data()[i] == 3 || heights.data()[i] < -5) heights.data()[i] = std::numeric_limits<float>::quiet_NaN();
  }
}

HeightField halved_tile(const HeightField& heights, const RunContext& run) {
  GridFrame frame = heights.frame();
  frame.width /= 2;
  frame.height /= 2;
  frame.cell_m *= 2;
  return geom::resample(heights, frame, run);
}

}  // namespace

bool is_held_out(const std::string& name) { return Seed{17}.derive(name.substr(0, name.find('_'))).value % 5 == 0; }

std::vector<GroundTile> read_ground(const std::string& folder, bool held_out, const RunContext& run) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".tif" && shows_land(name) && is_held_out(name) == held_out)
      files.push_back(entry.path().string());
  }
  if (error) throw InvalidArgument("--dem", folder + " cannot be read: " + error.message());
  if (files.empty()) throw InvalidArgument("--dem", folder + " holds no elevation model of land (.tif) of this side");
  std::sort(files.begin(), files.end());
  std::vector<std::vector<GroundTile>> parts(files.size());
  parallel_blocks(run, static_cast<int64_t>(files.size()), 1, [&](int64_t begin, int64_t) {
    const std::string& file = files[static_cast<size_t>(begin)];
    RunContext quiet;
    quiet.threads = 1;
    quiet.cancelled = run.cancelled;
    io::ReadOptions options;
    options.run = quiet;
    GroundTile tile{std::filesystem::path(file).stem().string(), io::read_heights(file, options)};
    forget_level_water(tile.heights);
    GroundTile coarse{tile.name, halved_tile(tile.heights, quiet)};
    parts[static_cast<size_t>(begin)] = {std::move(tile), std::move(coarse)};
  });
  std::vector<GroundTile> out;
  for (std::vector<GroundTile>& part : parts) {
    for (GroundTile& tile : part) out.push_back(std::move(tile));
  }
  return out;
}

}  // namespace seamount::train

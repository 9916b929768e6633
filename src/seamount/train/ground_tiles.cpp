#include "seamount/train/ground_tiles.h"

#include <algorithm>
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

namespace fs = std::filesystem;

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

std::vector<fs::path> find_files(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string extension = at->path().extension().string();
    if (extension == ".tif" || extension == ".tiff" || extension == ".hgt") files.push_back(at->path());
  }
  if (error) throw InvalidArgument("--dem", folder + ": cannot be read: " + error.message());
  if (files.empty()) throw InvalidArgument("--dem", folder + ": holds no .tif or .hgt file");
  std::sort(files.begin(), files.end());
  return files;
}

/// Files side by side, each on one thread.
std::vector<GroundTile> read_tiles(const std::vector<fs::path>& files, const RunContext& run) {
  std::vector<GroundTile> tiles(files.size());
  parallel_blocks(run, static_cast<int64_t>(files.size()), 1, [&](int64_t begin, int64_t) {
    const auto i = static_cast<size_t>(begin);
    io::ReadOptions options;
    options.run.threads = 1;
    options.run.cancelled = run.cancelled;
    tiles[i] = {files[i].stem().string(), io::read_heights(files[i].string(), options)};
  });
  return tiles;
}

bool begins_with_any(const std::string& name, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(), [&](const std::string& s) { return name.starts_with(s); });
}

void check_known(const std::string& flag, const std::vector<std::string>& beginnings,
                 const std::vector<fs::path>& files) {
  for (const std::string& beginning : beginnings) {
    const auto fits = [&](const fs::path& file) { return file.stem().string().starts_with(beginning); };
    if (std::none_of(files.begin(), files.end(), fits))
      throw InvalidArgument(flag, "no elevation model of the folder has a name that begins with '" + beginning + "'");
  }
}

HeightField rows_of(const HeightField& heights, int begin, int end) {
  GridFrame frame = heights.frame();
  frame.north_m -= begin * frame.cell_m;
  frame.height = end - begin;
  HeightField part(frame);
  for (int y = begin; y < end; ++y)
    std::copy(heights.row(y).begin(), heights.row(y).end(), part.row(y - begin).begin());
  return part;
}

/// Holds out the southern fifth of each tile that is high enough to be divided.
void divide(ChosenGround& ground) {
  constexpr double kHeldOut = 0.2;
  constexpr int kGap = 32;
  for (GroundTile& tile : ground.learned) {
    const int height = tile.heights.height(), border = static_cast<int>((1.0 - kHeldOut) * height);
    if (border <= 2 * kGap) continue;
    ground.held_out.push_back({tile.name, rows_of(tile.heights, border, height)});
    tile.heights = rows_of(tile.heights, 0, border - kGap);
  }
}

}  // namespace

bool is_held_out(const std::string& name) { return Seed{17}.derive(name.substr(0, name.find('_'))).value % 5 == 0; }

std::vector<GroundTile> read_ground(const std::string& folder, bool held_out, const RunContext& run) {
  std::vector<fs::path> files = find_files(folder);
  std::erase_if(files, [&](const fs::path& file) {
    const std::string name = file.stem().string();
    return !shows_land(name) || is_held_out(name) != held_out;
  });
  if (files.empty()) {
    throw InvalidArgument("--dem", folder + ": holds no elevation model of land whose ground is " +
                                       (held_out ? "held out" : "for training") +
                                       ", which the first word of a file's name decides");
  }
  std::vector<GroundTile> tiles = read_tiles(files, run), all(2 * tiles.size());
  parallel_blocks(run, static_cast<int64_t>(tiles.size()), 1, [&](int64_t begin, int64_t) {
    RunContext quiet;
    quiet.threads = 1;
    quiet.cancelled = run.cancelled;
    GroundTile& tile = tiles[static_cast<size_t>(begin)];
    forget_level_water(tile.heights);
    all[2 * static_cast<size_t>(begin) + 1] = {tile.name, halved_tile(tile.heights, quiet)};
    all[2 * static_cast<size_t>(begin)] = std::move(tile);
  });
  return all;
}

ChosenGround read_chosen_ground(const std::string& folder, const std::vector<std::string>& tiles,
                                const std::vector<std::string>& held_out, const RunContext& run) {
  std::vector<fs::path> files = find_files(folder);
  check_known("--tiles", tiles, files);
  check_known("--held-out", held_out, files);
  const auto out = [&](const std::string& name) { return begins_with_any(name, held_out); };
  std::erase_if(files, [&](const fs::path& file) {
    const std::string name = file.stem().string();
    return !out(name) && !tiles.empty() && !begins_with_any(name, tiles);
  });
  ChosenGround ground;
  for (GroundTile& tile : read_tiles(files, run))
    (out(tile.name) ? ground.held_out : ground.learned).push_back(std::move(tile));
  if (ground.learned.empty()) throw InvalidArgument("--held-out", "leaves no elevation model to learn from");
  if (ground.held_out.empty()) divide(ground);
  return ground;
}

}  // namespace seamount::train

#include "seamount/train/dem_tiles.h"

#include <algorithm>
#include <filesystem>

#include "seamount/io/raster.h"

namespace seamount::train {
namespace {

namespace fs = std::filesystem;

constexpr double kHeldOut = 0.2;
constexpr int kGap = 32;

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

HeightField rows_of(const HeightField& terrain, int begin, int end) {
  GridFrame frame = terrain.frame();
  frame.north_m -= begin * frame.cell_m;
  frame.height = end - begin;
  HeightField part(frame);
  for (int y = begin; y < end; ++y)
    std::copy(terrain.row(y).begin(), terrain.row(y).end(), part.row(y - begin).begin());
  return part;
}

/// Holds out the southern fifth of each tile that is high enough to be divided.
void divide(DemTiles& tiles) {
  for (DemTile& tile : tiles.learned) {
    const int height = tile.terrain.height(), border = static_cast<int>((1.0 - kHeldOut) * height);
    if (border <= 2 * kGap) continue;
    tiles.held_out.push_back({tile.name, rows_of(tile.terrain, border, height)});
    tile.terrain = rows_of(tile.terrain, 0, border - kGap);
  }
}

}  // namespace

DemTiles read_dem_tiles(const std::string& folder, const std::vector<std::string>& tiles,
                        const std::vector<std::string>& held_out, const RunContext& run) {
  const std::vector<fs::path> files = find_files(folder);
  check_known("--tiles", tiles, files);
  check_known("--held-out", held_out, files);
  DemTiles made;
  for (size_t i = 0; i < files.size(); ++i) {
    run.check_cancelled();
    const std::string name = files[i].stem().string();
    const bool out = begins_with_any(name, held_out);
    if (!out && !tiles.empty() && !begins_with_any(name, tiles)) continue;
    io::ReadOptions options;
    options.run = run.part(static_cast<double>(i) / files.size(), (i + 1.0) / files.size());
    (out ? made.held_out : made.learned).push_back({name, io::read_heights(files[i].string(), options)});
  }
  if (made.learned.empty()) throw InvalidArgument("--held-out", "leaves no elevation model to learn from");
  if (made.held_out.empty()) divide(made);
  return made;
}

}  // namespace seamount::train

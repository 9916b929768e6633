#include "seamount/io/engine_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::io {
namespace {

std::string_view name_of(Engine engine) { return Choices<Engine>::names[static_cast<size_t>(engine)]; }

/// Hundredths are enough of a place, and there are no negative zeros.
std::string shown(double value) { return format_number(std::round(value * 1e4) / 1e4 + 0.0); }

}  // namespace

bool engine_shares_borders(Engine engine) { return engine != Engine::godot; }

int engine_tile_size(Engine engine) { return engine == Engine::unreal ? 1009 : engine == Engine::godot ? 1024 : 1025; }

std::vector<int> engine_tile_sizes(Engine engine, bool share_border) {
  if (engine == Engine::godot) return {64, 128, 256, 512, 1024, 2048};
  if (engine == Engine::unreal && !share_border) return {};
  return engine_sizes(engine);
}

void check_engine_tiles(const TileOptions& options) {
  if (!options.engine) return;
  const Engine engine = *options.engine;
  if (engine == Engine::blender)
    throw InvalidArgument("engine", "Blender has no tiles: export the terrain as blender, or meshes in tiles");
  if (options.last_tiles == LastTiles::smaller)
    throw InvalidArgument("last_tiles", fmt::format("{} reads tiles of one size only: padded", name_of(engine)));
  if (engine == Engine::unity && !options.share_border)
    throw InvalidArgument("share_border", "Unity's terrains share their border samples, or there are gaps");
  if (engine == Engine::godot && options.share_border)
    throw InvalidArgument("share_border", "Terrain3D puts regions side by side: they share no samples");
  const std::vector<int> sizes = engine_tile_sizes(engine, options.share_border);
  if (!sizes.empty() && std::find(sizes.begin(), sizes.end(), options.tile_size) == sizes.end())
    throw InvalidArgument("tile_size", fmt::format("{} is not a size of tiles that {} reads; allowed are {}",
                                                   options.tile_size, name_of(engine), fmt::join(sizes, ", ")));
}

bool confuses_unreal(const std::string& path) {
  const std::string stem = std::filesystem::path(path).stem().string();
  const auto digit = [&](size_t i) {
    return i < stem.size() && std::isdigit(static_cast<unsigned char>(stem[i])) != 0;
  };
  for (size_t i = 1; i < stem.size(); ++i) {
    if (std::string_view("xyuv").find(stem[i - 1]) == std::string_view::npos) continue;
    if (digit(i) || (stem[i] == '-' && digit(i + 1))) return true;
  }
  return false;
}

std::string tile_suffix(std::optional<Engine> engine, int x, int y, int rows) {
  if (engine == Engine::unity) return fmt::format("_{}_{}", x, rows - 1 - y);
  return fmt::format("_x{}_y{}", x, y);
}

std::vector<ImportNumber> tile_place(const Tile& tile, int columns, int rows, const GridFrame& whole,
                                     const TileOptions& options, const HeightRange& range) {
  const double cell = whole.cell_m;
  switch (options.engine.value_or(Engine::blender)) {
    case Engine::unreal:
      if (!options.share_border) return {};  // one landscape of all
      return {{"Location X", shown(100.0 * cell * (tile.column - 0.5 * (whole.width - 1)))},
              {"Location Y", shown(100.0 * cell * (tile.row - 0.5 * (whole.height - 1)))}};
    case Engine::unity:
      return {{"Position X", shown(cell * tile.column)},
              {"Position Y", shown(range.low_m)},
              {"Position Z", shown(cell * (rows - 1 - tile.y) * (options.tile_size - 1))}};
    case Engine::godot: {
      const int x = tile.x - columns / 2, y = tile.y - rows / 2;
      return {{"region", fmt::format("{}, {}", x, y)},
              {"Position X", shown(cell * options.tile_size * x)},
              {"Position Z", shown(cell * options.tile_size * y)}};
    }
    case Engine::blender:
      break;
  }
  return {};
}

}  // namespace seamount::io

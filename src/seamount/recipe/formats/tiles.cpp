// Rasters cut into tiles, for GIS and for the engines that load worlds in pieces.
#include "seamount/io/tiles.h"

#include "seamount/io/engine_tiles.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/engine_fit.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

/// Who reads the tiles; any: nobody in particular.
enum class TilesFor { any, unreal, unity, godot };

}  // namespace
}  // namespace seamount::recipe

template <>
struct seamount::Choices<seamount::recipe::TilesFor> {
  static constexpr std::array<std::string_view, 4> names = {"any", "unreal", "unity", "godot"};
};

namespace seamount::recipe {
namespace {

struct TilesParams {
  TilesFor engine = TilesFor::any;
  int tile_size = 1025;
  io::LastTiles last_tiles = io::LastTiles::by_format;
  bool share_border = true;
  std::optional<double> low_m;
  std::optional<double> high_m;

  static constexpr auto fields() {
    using P = TilesParams;
    return std::tuple(
        field(&P::engine, "engine",
              "who reads them: sizes, codes, row order and names are the engine's, with the numbers to type in, and "
              "fields become masks of 8 bits"),
        field(&P::tile_size, "tile_size", "", between(2, 16385),
              "samples a side of a tile; if absent, of unreal 1009 and of godot 1024"),
        field(&P::last_tiles, "last_tiles",
              "where the terrain is not a whole number of tiles, the last ones are padded with its edge or smaller; "
              "by_format: smaller in .tif and .asc, padded in the others"),
        field(&P::share_border, "share_border",
              "the last row and column of a tile are the first of the next one; if absent, not of godot"),
        field(&P::low_m, "low_m", "m", between(-20000, 20000), "16-bit files: height of code 0, for all tiles"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "16-bit files: height of code 65535, for all tiles"));
  }

  std::optional<io::Engine> for_engine() const {
    if (engine == TilesFor::any) return std::nullopt;
    return static_cast<io::Engine>(static_cast<int>(engine) - 1);
  }
  io::TileOptions options() const { return {tile_size, last_tiles, share_border, for_engine()}; }
};

/// What is absent is as the engine wants it; what it does not read is reported.
Json complete(const Json& given, const ReadPlace& place) {
  auto params = read_params<TilesParams>(given, place);
  const std::optional<io::Engine> engine = params.for_engine();
  if (!engine) return write_params(params);
  if (!given.contains("tile_size")) params.tile_size = io::engine_tile_size(*engine);
  if (!given.contains("share_border")) params.share_border = io::engine_shares_borders(*engine);
  try {
    io::check_engine_tiles(params.options());
  } catch (const InvalidArgument& error) {
    place.fail(error);
  }
  return write_params(params);
}

void write(const TilesParams& params, const io::WindowedRaster& raster, const std::string& path,
           const io::Provenance& provenance, const RunContext& run,
           const std::optional<io::RasterExtremes>& extremes = {}) {
  io::write_tiles(raster, path, params.options(),
                  {.range = height_range(params.low_m, params.high_m), .provenance = provenance}, run, extremes);
}

void write_whole(const TilesParams& params, const OutputCall& call) {
  const Value value =
      io::can_hold_voids(call.path) ? call.value : call.value.without_voids(call.value.kind().name, call.run);
  const bool heights = value.is<kinds::Terrain>();
  const Grid<float>& cells = heights ? value.get<kinds::Terrain>() : value.get<kinds::Field>();
  write(params, io::windows_of(cells, heights), call.path, call.provenance, call.run);
}

bool write_windows(const Json& given, const WindowedCall& call) {
  const auto params = read_complete<TilesParams>(given);
  const bool heights = &call.kind == &kinds::Terrain::kind();
  const io::WindowedRaster raster{call.frame,
                                  [&](int column, int row, int width, int height) {
                                    const Value window = call.window(column, row, width, height);
                                    return heights ? window.get<kinds::Terrain>() : window.get<kinds::Field>();
                                  },
                                  heights};
  std::optional<io::RasterExtremes> extremes;
  if (!io::can_hold_voids(call.path)) {
    extremes = io::extremes_of(raster, call.run.part(0.0, 0.2));
    if (extremes->unknown_cells > 0) return false;  // to be filled, for which all of it is looked at
  }
  write(params, raster, call.path, call.provenance, extremes ? call.run.part(0.2, 1.0) : call.run, extremes);
  return true;
}

}  // namespace

void add_tiles_format(Registry& registry) {
  const std::vector<std::string> files = {".tif", ".asc", ".png", ".exr", ".r16", ".raw", ".r32", ".npy"};
  OutputFormat format = make_format<TilesParams>(
      {"tiles",
       "a terrain or a mask cut into tiles with its own cells, one range of heights, and a list of them; for Unreal, "
       "Unity and Godot as their tiled imports read them",
       files,
       {},
       {&kinds::Terrain::kind(), &kinds::Field::kind()}},
      write_whole);
  format.complete = complete;
  format.write_windows = write_windows;
  format.prepare = [](const Json& params, const Kind& kind, const std::string& path) -> std::vector<Preparation> {
    if (const auto engine = read_complete<TilesParams>(params).for_engine())
      io::check_engine_path(path, *engine, &kind == &kinds::Terrain::kind());
    return {};
  };
  format.files = [](const Json& params, const Kind&, const std::string& path) -> std::vector<std::string> {
    const std::string tiles = io::tiles_pattern(path, read_complete<TilesParams>(params).for_engine());
    std::vector<std::string> all = {io::tiles_manifest(path)};
    const auto each = io::written_files(tiles);
    all.insert(all.end(), each.begin(), each.end());
    return all;
  };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

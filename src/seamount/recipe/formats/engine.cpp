// Height maps for engines, and tiles: terrain.samples brings the terrain to their samples.
#include "seamount/io/engine.h"

#include <filesystem>

#include "seamount/io/tiles.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/engine_fit.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

struct EngineParams {
  int size = 0;
  Fit fit = Fit::by_engine;
  std::optional<double> low_m;
  std::optional<double> high_m;

  static constexpr auto fields() {
    using P = EngineParams;
    return std::tuple(
        field(&P::size, "size", "", between(0, 16385),
              "samples a side; 0: the largest that the engine takes and the terrain fills"),
        field(&P::fit, "fit", kFitMeaning),
        field(&P::low_m, "low_m", "m", between(-20000, 20000),
              "height of the lowest code; chosen with room to sculpt if absent"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "height of the highest code; chosen if absent"));
  }
};

struct TilesParams {
  int tile_size = 1025;
  io::LastTiles last_tiles = io::LastTiles::by_format;
  bool share_border = true;
  std::optional<double> low_m;
  std::optional<double> high_m;

  static constexpr auto fields() {
    using P = TilesParams;
    return std::tuple(
        field(&P::tile_size, "tile_size", "", between(2, 16385), "samples a side of a tile"),
        field(&P::last_tiles, "last_tiles",
              "where the terrain is not a whole number of tiles, the last ones are padded with its edge or smaller; "
              "by_format: smaller in .tif and .asc, padded in the others"),
        field(&P::share_border, "share_border", "the last row and column of a tile are the first of the next one"),
        field(&P::low_m, "low_m", "m", between(-20000, 20000), "16-bit files: height of code 0, for all tiles"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "16-bit files: height of code 65535, for all tiles"));
  }
};

/// An engine's format. The sizes that it reads are known before anything runs.
void add_engine(Registry& registry, io::Engine engine, OutputFormat row) {
  row.accepts = {&kinds::Terrain::kind()};
  OutputFormat format =
      make_format<EngineParams>(std::move(row), [engine](const EngineParams& p, const OutputCall& call) {
        io::write_for_engine(call.value.get<kinds::Terrain>(), engine, call.path,
                             {.range = height_range(p.low_m, p.high_m), .provenance = call.provenance});
      });
  const std::vector<int>& sizes = io::engine_sizes(engine);
  format.complete = [&sizes, name = format.name](const Json& given, const ReadPlace& place) {
    const auto params = read_params<EngineParams>(given, place);
    check_fit(params.size, params.fit, sizes, name, place);
    return write_params(params);
  };
  format.prepare = [&sizes](const Json& params, const Kind&, const std::string&) -> std::vector<Preparation> {
    const auto read = read_complete<EngineParams>(params);
    return {{"", "terrain.samples", "terrain", samples_params(read.size, read.fit, sizes)}};
  };
  format.files = [](const Json&, const Kind&, const std::string& path) -> std::vector<std::string> {
    return {path, io::sidecar_path(path)};
  };
  registry.add(std::move(format));
}

void add_tiles(Registry& registry) {
  const std::vector<std::string> files = {".tif", ".asc", ".png", ".exr", ".r16", ".raw", ".r32", ".npy"};
  OutputFormat format = make_format<TilesParams>(
      {"tiles",
       "the terrain cut into tiles with its own cells, one range of heights, and a list of them",
       files,
       {},
       {&kinds::Terrain::kind()}},
      [](const TilesParams& params, const OutputCall& call) {
        const Value value =
            io::can_hold_voids(call.path) ? call.value : call.value.without_voids(call.value.kind().name, call.run);
        io::write_tiles(
            value.get<kinds::Terrain>(), call.path,
            {.tile_size = params.tile_size, .last_tiles = params.last_tiles, .share_border = params.share_border},
            {.range = height_range(params.low_m, params.high_m), .provenance = call.provenance}, call.run);
      });
  format.files = [](const Json&, const Kind&, const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    std::vector<std::string> all = {io::tiles_manifest(path)};
    const auto tiles = io::written_files(path.substr(0, path.size() - extension.size()) + "_x*_y*" + extension);
    all.insert(all.end(), tiles.begin(), tiles.end());
    return all;
  };
  registry.add(std::move(format));
}

}  // namespace

void add_engine_formats(Registry& registry) {
  using enum io::Engine;
  add_engine(
      registry, unreal,
      {"unreal", "16-bit landscape for Unreal Engine, with the scale to type in", {".r16", ".raw", ".png"}, {}, {}});
  add_engine(registry, unity,
             {"unity", "16-bit RAW for Unity terrain, with the size to type in", {".raw", ".r16"}, {}, {}});
  add_engine(registry, godot, {"godot", "EXR in metres for Godot's Terrain3D and HTerrain", {".exr", ".r16"}, {}, {}});
  add_engine(registry, blender, {"blender", "EXR in metres for a displacement modifier", {".exr"}, {}, {}});
  add_tiles(registry);
}

}  // namespace seamount::recipe

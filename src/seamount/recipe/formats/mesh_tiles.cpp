// Meshes in tiles, made tile by tile from windows of a terrain (geom/mesh/window_mesh.h).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "seamount/geom/mesh/tile_texture.h"
#include "seamount/geom/mesh/window_mesh.h"
#include "seamount/io/mesh_file.h"
#include "seamount/io/mesh_scene.h"
#include "seamount/io/windowed_raster.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/engine_fit.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

struct MeshTilesParams {
  int tile_size = 513;
  std::optional<double> max_error_m;
  int lods = 1;
  double vertical_scale = 1.0;
  int texture_px = 2048;
  bool water = true;

  static constexpr auto fields() {
    using P = MeshTilesParams;
    return std::tuple(
        field(&P::tile_size, "tile_size", "", between(3, 8193),
              "samples a side of a tile, of which neighbours share the border; the last ones are as small as what is "
              "left"),
        field(&P::max_error_m, "max_error_m", "m", between(0, 20000),
              "no cell is farther above or below the finest level; a tenth of a cell if absent, 0: every cell is a "
              "vertex"),
        field(&P::lods, "lods", "", between(1, 8), "levels of detail, each with twice the error of the one before"),
        field(&P::vertical_scale, "vertical_scale", "", between(0.01, 100), "heights are multiplied by it"),
        field(&P::texture_px, "texture_px", "", between(0, 16384),
              "size of the texture of the whole, of which each tile has its part; 0: none"),
        field(&P::water, "water", "show the sea in the texture, whose colours tell its depth"));
  }
};

std::string tile_path(const std::string& path, const std::string& column, const std::string& row,
                      const std::string& level) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return path.substr(0, path.size() - extension.size()) + "_x" + column + "_y" + row + "_lod" + level + extension;
}

bool has_texture(const Json& params, const std::string& path) {
  const std::filesystem::path extension = std::filesystem::path(path).extension();
  return params["texture_px"] != 0 && (extension == ".glb" || extension == ".obj");
}

bool is_glb(const std::string& path) { return std::filesystem::path(path).extension() == ".glb"; }

struct Job {
  const MeshTilesParams& params;
  const io::WindowedRaster& terrain;
  const Image* texture;
  std::string path;
  const io::Provenance& provenance;

  geom::WindowMeshOptions options() const {
    return {params.max_error_m.value_or(0.1 * terrain.frame.cell_m), params.lods, params.vertical_scale};
  }
  int count(int samples) const { return std::max(1, (samples - 2) / (params.tile_size - 1) + 1); }
  geom::CellBox box(int x, int y) const {
    const int steps = params.tile_size - 1;
    return {{x * steps, y * steps},
            {std::min((x + 1) * steps, terrain.frame.width - 1), std::min((y + 1) * steps, terrain.frame.height - 1)}};
  }
};

io::TileMesh written(const Job& job, Mesh mesh, int x, int y, int level) {
  const geom::CellBox box = job.box(x, y);
  io::TileMesh tile{.x = x,
                    .y = y,
                    .level = level,
                    .path = tile_path(job.path, std::to_string(x), std::to_string(y), std::to_string(level)),
                    .column = box.first.x,
                    .row = box.first.y,
                    .width = box.last.x - box.first.x + 1,
                    .height = box.last.y - box.first.y + 1,
                    .east_m = mesh.offset.x,
                    .north_m = mesh.offset.y,
                    .largest_error_m = mesh.largest_error_m,
                    .triangles = mesh.parts[0].triangle_count()};
  const auto [low, high] = geom::heights_of(mesh.parts[0]);
  tile.low_m = low;
  tile.high_m = high;
  mesh.offset = {};  // the list and the scene place it
  if (job.texture == nullptr) {
    io::write_mesh(mesh, tile.path, {.provenance = job.provenance});
  } else {
    const Image part = geom::tile_texture(*job.texture, mesh.parts[0]);
    io::write_mesh(mesh, tile.path, {.texture = &part, .provenance = job.provenance});
  }
  return tile;
}

/// All levels of a tile, from the cells around it.
std::vector<io::TileMesh> write_tile(const Job& job, int x, int y, const HeightField& heights, const RunContext& run) {
  const geom::CellBox box = job.box(x, y), around = geom::cells_around(box, job.terrain.frame, job.options());
  std::vector<Mesh> meshes = geom::window_meshes({heights, job.terrain.frame, around.first}, box, job.options(), run);
  std::vector<io::TileMesh> tiles;
  for (size_t level = 0; level < meshes.size(); ++level)
    tiles.push_back(written(job, std::move(meshes[level]), x, y, static_cast<int>(level)));
  return tiles;
}

void say_sizes(const io::MeshTileSet& set, const std::string& path, const RunContext& run) {
  for (int level = 0; level < set.levels; ++level) {
    size_t triangles = 0;
    double error = 0.0;
    for (const io::TileMesh& tile : set.tiles) {
      if (tile.level != level) continue;
      triangles += tile.triangles;
      error = std::max(error, tile.largest_error_m);
    }
    run.say(fmt::format("level {}: {} x {} tiles of {} triangles, at most {:.3g} m from the terrain", level,
                        set.columns, set.rows, triangles, error));
  }
  run.say(fmt::format("{} says where each tile goes{}", std::filesystem::path(io::mesh_list(path)).filename().string(),
                      is_glb(path) ? "; " + std::filesystem::path(io::mesh_scene(path)).filename().string() +
                                         " is a scene of all, which needs their files beside it"
                                   : std::string()));
}

void write_all(const Job& job, const RunContext& run) {
  const GridFrame& frame = job.terrain.frame;
  if (frame.width < 2 || frame.height < 2) throw InvalidArgument("heights", "a mesh needs at least 2 x 2 cells");
  io::MeshTileSet set{.frame = frame,
                      .tile_size = job.params.tile_size,
                      .columns = job.count(frame.width),
                      .rows = job.count(frame.height),
                      .levels = job.params.lods,
                      .vertical_scale = job.params.vertical_scale,
                      .tiles = {},
                      .provenance = job.provenance};
  std::vector<io::CellWindow> windows;
  for (int y = 0; y < set.rows; ++y) {
    for (int x = 0; x < set.columns; ++x) {
      const geom::CellBox around = geom::cells_around(job.box(x, y), frame, job.options());
      windows.push_back(
          {around.first.x, around.first.y, around.last.x - around.first.x + 1, around.last.y - around.first.y + 1});
    }
  }
  std::vector<std::vector<io::TileMesh>> made(windows.size());
  io::for_each_window(job.terrain, windows, run.part(0.0, 0.95), [&](size_t i, const HeightField& heights) {
    const auto x = static_cast<int>(i) % set.columns, y = static_cast<int>(i) / set.columns;
    made[i] = write_tile(job, x, y, heights, {.threads = 1, .cancelled = run.cancelled});
  });
  for (const auto& levels : made) set.tiles.insert(set.tiles.end(), levels.begin(), levels.end());
  io::write_mesh_list(set, job.path);
  if (is_glb(job.path)) io::write_mesh_scene(set, job.path);
  say_sizes(set, job.path, run);
}

const Image* texture_of(const Values& prepared) {
  const auto found = prepared.find("texture");
  return found == prepared.end() ? nullptr : &found->second.get<kinds::Image>();
}

void write_whole(const MeshTilesParams& params, const OutputCall& call) {
  const Value filled = call.value.without_voids(call.value.kind().name, call.run);
  const io::WindowedRaster terrain = io::windows_of(filled.get<kinds::Terrain>());
  write_all({params, terrain, texture_of(call.prepared), call.path, call.provenance}, call.run);
}

bool write_windows(const Json& given, const WindowedCall& call) {
  const auto params = read_complete<MeshTilesParams>(given);
  const io::WindowedRaster terrain{call.frame, [&](int column, int row, int width, int height) {
                                     return call.window(column, row, width, height).get<kinds::Terrain>();
                                   }};
  if (io::extremes_of(terrain, call.run.part(0.0, 0.1)).unknown_cells > 0) return false;
  write_all({params, terrain, texture_of(call.prepared), call.path, call.provenance}, call.run.part(0.1, 1.0));
  return true;
}

}  // namespace

void add_mesh_tiles_format(Registry& registry) {
  OutputFormat format = make_format<MeshTilesParams>(
      {"mesh_tiles",
       "triangles in tiles that fit without cracks, of several levels, for worlds of any size: a list of where they go "
       "and, of GLB, a glTF scene of all",
       {".glb", ".obj", ".ply", ".stl"},
       {},
       {&kinds::Terrain::kind()}},
      write_whole);
  format.write_windows = write_windows;
  format.prepare = [](const Json& params, const Kind&, const std::string& path) -> std::vector<Preparation> {
    if (!has_texture(params, path)) return {};
    return {{"texture",
             "render.texture",
             "image",
             {{"size_px", std::max(16, params["texture_px"].get<int>())}, {"water", params["water"]}}}};
  };
  format.files = [](const Json& params, const Kind&, const std::string& path) -> std::vector<std::string> {
    std::vector<std::string> all = {io::mesh_list(path)};
    if (is_glb(path)) all.push_back(io::mesh_scene(path));
    const std::filesystem::path tile(tile_path(path, "*", "*", "*"));
    all.push_back(tile.string());
    if (tile.extension() != ".obj") return all;
    const std::string stem = std::filesystem::path(tile).replace_extension().string();
    all.push_back(stem + ".mtl");
    if (has_texture(params, path)) all.push_back(stem + ".png");
    return all;
  };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

#include "seamount/io/mesh_file.h"

#include <algorithm>
#include <filesystem>

#include "seamount/geom/mesh/terrain_mesh.h"
#include "seamount/geom/mesh/tile_texture.h"
#include "seamount/geom/water/inland.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

struct MeshParams {
  int max_triangles = 400000;
  double max_error_m = 0.0;
  double vertical_scale = 1.0;
  double base_m = 0.0;
  bool water = true;
  int texture_px = 2048;
  int tiles = 0;
  int lods = 1;

  static constexpr auto fields() {
    using P = MeshParams;
    return std::tuple(
        field(&P::max_triangles, "max_triangles", "", between(0, 2000000000),
              "triangles of the ground, at most; 0: as many as max_error_m needs, or a vertex for each cell"),
        field(&P::max_error_m, "max_error_m", "m", between(0, 20000),
              "no more triangles than keep every cell so near, above or below; 0: max_triangles alone decide"),
        field(&P::vertical_scale, "vertical_scale", "", between(0.01, 100), "heights are multiplied by it"),
        field(&P::base_m, "base_m", "m", between(0, 20000),
              "above 0: a closed solid to print, with a flat bottom so far below the lowest height"),
        field(&P::water, "water",
              "show the sea: in the texture, whose colours tell its depth; in a GLB without one as a translucent "
              "surface"),
        field(&P::texture_px, "texture_px", "", between(0, 16384), "size of the texture; 0: none"),
        field(&P::tiles, "tiles", "", between(0, 256),
              "tiles along the longer side, that fit without cracks, as files NAME_x0_y0_lod0...; 0: one file"),
        field(&P::lods, "lods", "", between(1, 8),
              "levels of detail of the tiles, each with a quarter of the triangles and twice the error of the one "
              "before"));
  }

  bool is_tiled() const { return tiles > 0 || lods > 1; }
};

bool has_texture(const Json& params, const std::string& path) {
  const std::filesystem::path extension = std::filesystem::path(path).extension();
  return params["texture_px"] != 0 && (extension == ".glb" || extension == ".obj");
}

/// "isle.glb" as "isle_x0_y1_lod2.glb".
std::string tile_path(const std::string& path, const std::string& column, const std::string& row,
                      const std::string& level) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return path.substr(0, path.size() - extension.size()) + "_x" + column + "_y" + row + "_lod" + level + extension;
}

void write_tiles(const MeshParams& params, const geom::MeshOptions& options, const seamount::Image* texture,
                 const OutputCall& call) {
  const geom::MeshTiling tiling{.across = std::max(1, params.tiles), .levels = params.lods};
  geom::make_mesh_tiles(
      call.value.get<kinds::Terrain>(), options, tiling,
      [&](const geom::MeshTile& tile) {
        call.run.check_cancelled();
        const std::string path =
            tile_path(call.path, std::to_string(tile.column), std::to_string(tile.row), std::to_string(tile.level));
        if (texture == nullptr) return io::write_mesh(tile.mesh, path, {.provenance = call.provenance});
        Mesh mesh = tile.mesh;
        const seamount::Image part = geom::tile_texture(*texture, mesh.parts[0]);
        io::write_mesh(mesh, path, {.texture = &part, .provenance = call.provenance});
      },
      call.run);
}

void write_mesh(const MeshParams& params, const OutputCall& call) {
  const auto prepared = call.prepared.find("texture");
  const seamount::Image* texture = prepared == call.prepared.end() ? nullptr : &prepared->second.get<kinds::Image>();
  geom::MeshOptions options{.max_triangles = params.max_triangles,
                            .max_error_m = params.max_error_m,
                            .vertical_scale = params.vertical_scale,
                            .base_m = params.base_m,
                            .water = params.water && texture == nullptr};
  Grid<uint8_t> hollows;
  if (options.water && options.base_m == 0)
    hollows = geom::find_hollows(call.value.get<kinds::Terrain>(), 0.0F, {}, {.threads = call.run.threads});
  if (!hollows.empty()) options.hollows = &hollows;
  if (params.is_tiled()) return write_tiles(params, options, texture, call);
  const Mesh mesh = geom::make_mesh(call.value.get<kinds::Terrain>(), options, call.run.part(0.0, 0.8));
  io::write_mesh(mesh, call.path, {.texture = texture, .provenance = call.provenance});
  call.run.report(1.0);
}

}  // namespace

void add_mesh_format(Registry& registry) {
  const std::vector<std::string> files = {".glb", ".obj", ".ply", ".stl"};
  OutputFormat format = make_format<MeshParams>(
      {"mesh", "triangles: GLB and OBJ with texture, PLY, STL", files, files, {&kinds::Terrain::kind()}}, write_mesh);
  format.complete = [](const Json& given, const ReadPlace& place) {
    const auto params = read_params<MeshParams>(given, place);
    if (params.is_tiled() && params.base_m > 0)
      place.at("base_m").fail("tiles are open surfaces, a solid is one mesh: leave tiles and lods, or base_m, away");
    return write_params(params);
  };
  format.prepare = [](const Json& params, const Kind&, const std::string& path) -> std::vector<Preparation> {
    if (!has_texture(params, path)) return {};
    return {{"texture",
             "render.texture",
             "image",
             {{"size_px", std::max(16, params["texture_px"].get<int>())}, {"water", params["water"]}}}};
  };
  format.files = [](const Json& params, const Kind&, const std::string& path) -> std::vector<std::string> {
    const bool tiled = params["tiles"] != 0 || params["lods"] != 1;
    const std::filesystem::path file(tiled ? tile_path(path, "*", "*", "*") : path);
    if (file.extension() != ".obj") return {file.string()};
    const std::string stem = std::filesystem::path(file).replace_extension().string();
    if (!has_texture(params, path)) return {file.string(), stem + ".mtl"};
    return {file.string(), stem + ".mtl", stem + ".png"};
  };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

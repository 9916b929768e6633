#include "seamount/io/mesh_file.h"

#include <algorithm>
#include <filesystem>

#include "seamount/geom/mesh/terrain_mesh.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

struct MeshParams {
  int max_triangles = 400000;
  double vertical_scale = 1.0;
  double base_m = 0.0;
  bool water = true;
  int texture_px = 2048;

  static constexpr auto fields() {
    using P = MeshParams;
    return std::tuple(
        field(&P::max_triangles, "max_triangles", "", between(0, 2000000000), "simplified to about as many; 0: all"),
        field(&P::vertical_scale, "vertical_scale", "", between(0.01, 100), "heights are multiplied by it"),
        field(&P::base_m, "base_m", "m", between(0, 20000),
              "above 0: a solid with a flat bottom so far below the lowest height"),
        field(&P::water, "water", "GLB: a translucent surface at sea level"),
        field(&P::texture_px, "texture_px", "", between(0, 16384), "size of the texture; 0: none"));
  }
};

bool has_texture(const Json& params, const std::string& path) {
  const std::filesystem::path extension = std::filesystem::path(path).extension();
  return params["texture_px"] != 0 && (extension == ".glb" || extension == ".obj");
}

void write_mesh(const MeshParams& params, const OutputCall& call) {
  const auto texture = call.prepared.find("texture");
  const Mesh mesh = geom::make_mesh(call.value.get<kinds::Terrain>(),
                                    {.max_triangles = params.max_triangles,
                                     .vertical_scale = params.vertical_scale,
                                     .base_m = params.base_m,
                                     .water = params.water},
                                    call.run.part(0.0, 0.8));
  io::write_mesh(mesh, call.path,
                 {.texture = texture == call.prepared.end() ? nullptr : &texture->second.get<kinds::Image>(),
                  .provenance = call.provenance});
  call.run.report(1.0);
}

}  // namespace

void add_mesh_format(Registry& registry) {
  const std::vector<std::string> files = {".glb", ".obj", ".ply", ".stl"};
  OutputFormat format = make_format<MeshParams>(
      {"mesh", "triangles: GLB and OBJ with texture, PLY, STL", files, files, {&kinds::Terrain::kind()}}, write_mesh);
  format.prepare = [](const Json& params, const Kind&, const std::string& path) -> std::vector<Preparation> {
    if (!has_texture(params, path)) return {};
    return {{"texture", "render.texture", "image", {{"size_px", std::max(16, params["texture_px"].get<int>())}}}};
  };
  format.files = [](const Json& params, const Kind&, const std::string& path) -> std::vector<std::string> {
    const std::filesystem::path file(path);
    if (file.extension() != ".obj") return {path};
    const std::string stem = std::filesystem::path(file).replace_extension().string();
    if (!has_texture(params, path)) return {path, stem + ".mtl"};
    return {path, stem + ".mtl", stem + ".png"};
  };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

// Things as GLB, as tables for engines, as a world for robot simulators.
#include "seamount/io/things_file.h"

#include <algorithm>
#include <filesystem>

#include "seamount/geom/mesh/terrain_mesh.h"
#include "seamount/geom/water/inland.h"
#include "seamount/io/gazebo.h"
#include "seamount/ops/render/texture.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

enum class GlbInstances { extension, nodes };

}  // namespace
}  // namespace seamount::recipe

template <>
struct seamount::Choices<seamount::recipe::GlbInstances> {
  static constexpr std::array<std::string_view, 2> names = {"extension", "nodes"};
};

namespace seamount::recipe {
namespace {

struct ThingsParams {
  GlbInstances instances = GlbInstances::extension;
  bool ground = true;
  int max_triangles = 400000;
  int texture_px = 2048;

  static constexpr auto fields() {
    using P = ThingsParams;
    return std::tuple(
        field(&P::instances, "instances",
              "extension: one node for each shape and level (EXT_mesh_gpu_instancing); nodes: one for each thing, for "
              "readers that do not know it"),
        field(&P::ground, "ground", "the terrain in the same file, if it goes with the things"),
        field(&P::max_triangles, "max_triangles", "", between(0, 2000000000), "of the terrain, at most; 0: all"),
        field(&P::texture_px, "texture_px", "", between(0, 16384), "size of the terrain's texture; 0: none"));
  }
};

void write_things(const ThingsParams& params, const OutputCall& call) {
  const auto& things = call.value.get<kinds::Things>();
  io::ThingsFileOptions options;
  options.instances = params.instances == GlbInstances::extension;
  options.provenance = call.provenance;
  Mesh mesh;
  Image texture;
  if (params.ground && !things.ground.empty()) {
    geom::MeshOptions wanted{.max_triangles = params.max_triangles, .water = params.texture_px == 0};
    Grid<uint8_t> hollows;
    if (wanted.water) hollows = geom::find_hollows(things.ground, 0.0F, {}, {.threads = call.run.threads});
    if (!hollows.empty()) wanted.hollows = &hollows;
    mesh = geom::make_mesh(things.ground, wanted, call.run.part(0.0, 0.5));
    options.ground = &mesh;
    if (params.texture_px > 0) {
      texture = render::texture(things.ground, nullptr, {.size_px = std::max(16, params.texture_px)},
                                call.run.part(0.5, 0.9));
      options.texture = &texture;
    }
  }
  io::write_things_glb(things, call.path, options);
  call.run.report(1.0);
}

struct PlacementParams {
  io::ThingEngine engine = io::ThingEngine::unreal;

  static constexpr auto fields() {
    using P = PlacementParams;
    return std::tuple(field(&P::engine, "engine",
                            "whose axes: unreal (cm, left-handed, z up), unity (m, left-handed, y up), godot (m, "
                            "right-handed, y up), blender (m, right-handed, z up)"));
  }
};

struct ThingWorldParams {
  int max_triangles = 200000;
  int max_collisions = 2000;
  bool water = true;
  bool buoyancy = false;
  int texture_px = 2048;

  static constexpr auto fields() {
    using P = ThingWorldParams;
    return std::tuple(
        field(&P::max_triangles, "max_triangles", "", between(0, 2000000000), "of the ground, about; 0: all"),
        field(&P::max_collisions, "max_collisions", "", between(0, 1000000),
              "so many of the largest things can be bumped into"),
        field(&P::water, "water", "a translucent sheet at sea level"),
        field(&P::buoyancy, "buoyancy", "gz-sim's systems, with sea water below 0 m and air above"),
        field(&P::texture_px, "texture_px", "", between(0, 16384),
              "size of the ground's texture along its longer side; 0: none"));
  }
};

void write_world(const ThingWorldParams& params, const OutputCall& call) {
  const auto& things = call.value.get<kinds::Things>();
  if (things.ground.empty())
    throw InvalidArgument("things", "they have no ground, which a world needs: make them with keep_ground");
  const Mesh mesh =
      geom::make_mesh(things.ground, {.max_triangles = params.max_triangles, .water = false}, call.run.part(0.0, 0.5));
  Image texture;
  if (params.texture_px > 0)
    texture =
        render::texture(things.ground, nullptr, {.size_px = std::max(16, params.texture_px), .water_clarity = 5.0},
                        call.run.part(0.5, 0.9));
  io::write_gazebo(mesh, things.ground.frame(), call.path,
                   {.texture = params.texture_px > 0 ? &texture : nullptr,
                    .water = params.water,
                    .buoyancy = params.buoyancy,
                    .things = &things,
                    .max_collisions = params.max_collisions,
                    .provenance = call.provenance},
                   call.run);
}

}  // namespace

void add_things_formats(Registry& registry) {
  const std::vector<const Kind*> accepts = {&kinds::Things::kind()};
  registry.add(make_format<ThingsParams>(
      {"things", "models and their instances, with the terrain, as GLB", {".glb"}, {".glb"}, accepts}, write_things));
  OutputFormat placements = make_format<PlacementParams>(
      {"placements",
       "a table of places for an engine, and each model as a GLB file in a folder beside it",
       {".csv", ".json"},
       {".csv", ".json"},
       accepts},
      [](const PlacementParams& params, const OutputCall& call) {
        io::write_placements(call.value.get<kinds::Things>(), call.path, params.engine, call.provenance);
      });
  placements.files = [](const Json&, const Kind&, const std::string& path) -> std::vector<std::string> {
    const std::filesystem::path file(path);
    return {path, (file.parent_path() / (file.stem().string() + "_shapes") / "shape_*_lod*.glb").string()};
  };
  registry.add(std::move(placements));
  OutputFormat world = make_format<ThingWorldParams>({"thing_world",
                                                      "a world for the robot simulator Gazebo: ground, sea, sun, and "
                                                      "things as static models",
                                                      {".sdf", ".world"},
                                                      {".sdf", ".world"},
                                                      accepts},
                                                     write_world);
  world.files = [](const Json& params, const Kind&, const std::string& path) {
    return io::gazebo_files(path, true, params["texture_px"] != 0, true);
  };
  registry.add(std::move(world));
}

}  // namespace seamount::recipe

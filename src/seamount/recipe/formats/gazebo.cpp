// Worlds for robot simulators: the ground as the samples of a height map, or as a mesh.
#include "seamount/io/gazebo.h"

#include <fmt/format.h>

#include <algorithm>

#include "seamount/geom/mesh/terrain_mesh.h"
#include "seamount/io/texture_part.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

enum class GazeboGround { height_map, mesh };
enum class GazeboFit { crop, pad };

}  // namespace
}  // namespace seamount::recipe

template <>
struct seamount::Choices<seamount::recipe::GazeboGround> {
  static constexpr std::array<std::string_view, 2> names = {"height_map", "mesh"};
};

template <>
struct seamount::Choices<seamount::recipe::GazeboFit> {
  static constexpr std::array<std::string_view, 2> names = {"crop", "pad"};
};

namespace seamount::recipe {
namespace {

struct GazeboParams {
  GazeboGround ground = GazeboGround::height_map;
  int size = 0;
  GazeboFit fit = GazeboFit::crop;
  int bits = 16;
  int max_triangles = 200000;
  bool water = true;
  bool buoyancy = false;
  int texture_px = 2048;

  static constexpr auto fields() {
    using P = GazeboParams;
    return std::tuple(
        field(&P::ground, "ground",
              "height_map: a picture of heights; mesh: OBJ, all of the terrain, as long as it is"),
        field(&P::size, "size", "", between(0, 4097),
              "height map: samples a side, 2^n + 1; 0: the largest that the terrain fills, at most 2049"),
        field(&P::fit, "fit",
              "height map of a terrain that is no square: crop takes its middle, pad adds its repeated edge"),
        field(&P::bits, "bits", "", between(8, 16),
              "height map: 16, for gz-sim from Garden on; 8, for Fortress and Gazebo classic"),
        field(&P::max_triangles, "max_triangles", "", between(0, 2000000000),
              "mesh: simplified to about as many; 0: all"),
        field(&P::water, "water", "a translucent sheet at sea level"),
        field(&P::buoyancy, "buoyancy", "gz-sim's systems, with sea water below 0 m and air above"),
        field(&P::texture_px, "texture_px", "", between(0, 16384),
              "size of the ground's texture along the terrain's longer side; 0: none"));
  }
};

bool is_mesh(const Json& params) { return params["ground"] == "mesh"; }

void write_gazebo(const GazeboParams& params, const OutputCall& call) {
  const auto& terrain = call.value.get<kinds::Terrain>();
  const auto texture = call.prepared.find("texture");
  const Image* picture = texture == call.prepared.end() ? nullptr : &texture->second.get<kinds::Image>();
  io::GazeboOptions options{.texture = picture,
                            .bits = params.bits,
                            .water = params.water,
                            .buoyancy = params.buoyancy,
                            .provenance = call.provenance};
  if (params.ground == GazeboGround::mesh) {
    const Mesh mesh =
        geom::make_mesh(terrain, {.max_triangles = params.max_triangles, .water = false}, call.run.part(0.0, 0.8));
    return io::write_gazebo(mesh, terrain.frame(), call.path, options, call.run);
  }
  const auto& samples = call.prepared.find("samples")->second.get<kinds::Terrain>();
  Image part;
  if (picture != nullptr) {
    part = io::texture_between(*picture, terrain.frame(), samples.frame());
    options.texture = &part;
  }
  io::write_gazebo(samples, call.path, options, call.run);
}

std::vector<Preparation> prepare(const Json& params, const Kind&, const std::string&) {
  std::vector<Preparation> all;
  if (!is_mesh(params)) {
    std::vector<int> choices = io::gazebo_sizes();
    choices.pop_back();  // 4097 only where it is asked for
    all.push_back({"samples",
                   "terrain.samples",
                   "terrain",
                   {{"samples", params["size"]}, {"fit", params["fit"]}, {"choices", choices}}});
  }
  const int pixels = params["texture_px"].get<int>();
  if (pixels > 0)
    all.push_back({"texture", "render.texture", "image", {{"size_px", std::max(16, pixels)}, {"water_clarity", 5.0}}});
  return all;
}

}  // namespace

void add_gazebo_format(Registry& registry) {
  OutputFormat format = make_format<GazeboParams>({"gazebo",
                                                   "a world for the robot simulator Gazebo: ground, sea and sun, and "
                                                   "the ground as a model in a folder beside it",
                                                   {".sdf", ".world"},
                                                   {".sdf", ".world"},
                                                   {&kinds::Terrain::kind()}},
                                                  write_gazebo);
  format.complete = [](const Json& given, const ReadPlace& place) {
    const auto params = read_params<GazeboParams>(given, place);
    const auto& sizes = io::gazebo_sizes();
    if (params.size > 0 && std::find(sizes.begin(), sizes.end(), params.size) == sizes.end())
      place.at("size").fail(
          fmt::format("{} is not a size that gazebo reads; allowed are {}", params.size, fmt::join(sizes, ", ")));
    if (params.bits != 8 && params.bits != 16)
      place.at("bits").fail(fmt::format("{} is neither 8 nor 16", params.bits));
    return write_params(params);
  };
  format.prepare = prepare;
  format.files = [](const Json& params, const Kind&, const std::string& path) {
    return io::gazebo_files(path, is_mesh(params), params["texture_px"] != 0);
  };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

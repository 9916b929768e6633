#include "seamount/recipe/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "seamount/geom/contour/lines.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/io/engine.h"
#include "seamount/io/image_file.h"
#include "seamount/io/mesh.h"
#include "seamount/io/raster.h"
#include "seamount/io/report.h"
#include "seamount/io/splat.h"
#include "seamount/io/tiles.h"
#include "seamount/io/tin_file.h"
#include "seamount/io/vector.h"
#include "seamount/ops/render/contours.h"
#include "seamount/ops/render/map.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/relief.h"
#include "seamount/ops/render/style.h"
#include "seamount/ops/render/texture.h"
#include "seamount/ops/terrain/layers.h"

namespace seamount::recipe {
namespace {

struct NoParams {
  static constexpr auto fields() { return std::tuple(); }
};

/// Heights of the codes of 16-bit files; both or none.
std::optional<io::HeightRange> height_range(const std::optional<double>& low, const std::optional<double>& high) {
  if (low.has_value() != high.has_value()) throw InvalidArgument("low_m", "low_m and high_m go together");
  if (!low) return std::nullopt;
  if (*low >= *high)
    throw InvalidArgument("low_m", format_number(*low) + " is not below high_m = " + format_number(*high));
  return io::HeightRange{*low, *high};
}

struct RasterParams {
  std::optional<double> low_m;
  std::optional<double> high_m;
  bool cloud_optimised = false;

  static constexpr auto fields() {
    using P = RasterParams;
    return std::tuple(
        field(&P::low_m, "low_m", "m", between(-20000, 20000),
              "16-bit files: height of code 0; the lowest height if absent"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000),
              "16-bit files: height of code 65535; the highest height if absent"),
        field(&P::cloud_optimised, "cloud_optimised", "GeoTIFF with overviews, laid out for reading over the network"));
  }
};

io::WriteOptions raster_options(const RasterParams& params, const OutputCall& call) {
  return {.range = height_range(params.low_m, params.high_m),
          .cloud_optimised = params.cloud_optimised,
          .provenance = call.provenance};
}

void write_raster(const RasterParams& params, const OutputCall& call) {
  const io::WriteOptions options = raster_options(params, call);
  switch (call.value.kind()) {
    case ValueKind::labels:
      return io::write_labels(call.value.regions(), call.path, options);
    case ValueKind::field:
      return io::write_field(call.value.scalars(), call.path, options);
    default:
      return io::write_heights(call.value.heights(), call.path, options);
  }
}

struct EngineParams {
  int size = 0;
  std::optional<double> low_m;
  std::optional<double> high_m;

  static constexpr auto fields() {
    using P = EngineParams;
    return std::tuple(
        field(&P::size, "size", "", between(0, 16385),
              "samples a side; 0: the largest that the engine takes and the terrain fills"),
        field(&P::low_m, "low_m", "m", between(-20000, 20000),
              "height of the lowest code; chosen with room to sculpt if absent"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "height of the highest code; chosen if absent"));
  }
};

int natural_size(const HeightField& terrain, io::Engine engine) {
  const int side = std::min(terrain.width(), terrain.height());
  const std::vector<int>& sizes = io::engine_sizes(engine);
  if (sizes.empty()) return side;
  int best = sizes.front();
  for (const int size : sizes) {
    if (size <= side + 1) best = size;  // 2049 samples for 2048 cells
  }
  return best;
}

template <io::Engine engine>
void write_engine(const EngineParams& params, const OutputCall& call) {
  const HeightField& terrain = call.value.heights();
  const GridFrame frame =
      io::engine_frame(terrain.frame(), params.size > 0 ? params.size : natural_size(terrain, engine));
  const io::EngineOptions options{.range = height_range(params.low_m, params.high_m), .provenance = call.provenance};
  if (frame == terrain.frame()) return io::write_for_engine(terrain, engine, call.path, options);
  io::write_for_engine(geom::resample(terrain, frame, call.run), engine, call.path, options);
}

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

void write_mesh(const MeshParams& params, const OutputCall& call) {
  const HeightField& terrain = call.value.heights();
  io::MeshOptions options{.max_triangles = params.max_triangles,
                          .vertical_scale = params.vertical_scale,
                          .base_m = params.base_m,
                          .water = params.water,
                          .provenance = call.provenance};
  const std::string extension = std::filesystem::path(call.path).extension().string();
  Image texture;
  if (params.texture_px > 0 && (extension == ".glb" || extension == ".obj")) {
    render::TextureParams look;
    look.size_px = std::max(16, params.texture_px);
    texture = render::texture(terrain, call.labels, look, call.run.part(0.0, 0.4));
    options.texture = &texture;
  }
  io::write_mesh(terrain, call.path, options, call.run.part(0.4, 1.0));
}

struct TilesParams {
  int tile_size = 1025;
  std::optional<double> low_m;
  std::optional<double> high_m;

  static constexpr auto fields() {
    using P = TilesParams;
    return std::tuple(
        field(&P::tile_size, "tile_size", "", between(2, 16385),
              "samples a side of a tile; neighbours share their border samples"),
        field(&P::low_m, "low_m", "m", between(-20000, 20000), "16-bit files: height of code 0, for all tiles"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "16-bit files: height of code 65535, for all tiles"));
  }
};

/// The terrain with as many samples as whole tiles need: at most one tile's worth of stretching to finer samples.
GridFrame tiled_frame(const GridFrame& frame, int tile_size) {
  const int step = tile_size - 1;
  const int side = std::max(1, static_cast<int>(std::lround(static_cast<double>(frame.width) / step)));
  GridFrame tiled = frame;
  const double span = frame.cell_m * (frame.width - 1);
  tiled.width = side * step + 1;
  tiled.cell_m = span / (tiled.width - 1);
  const int rows =
      std::max(1, static_cast<int>(std::floor((frame.height - 1) * frame.cell_m / (step * tiled.cell_m) + 1e-6)));
  tiled.height = rows * step + 1;
  tiled.west_m = frame.x(0) - 0.5 * tiled.cell_m;
  tiled.north_m = frame.y(0) + 0.5 * tiled.cell_m;
  return tiled;
}

void write_tiles(const TilesParams& params, const OutputCall& call) {
  const HeightField& terrain = call.value.heights();
  const io::WriteOptions options{.range = height_range(params.low_m, params.high_m), .provenance = call.provenance};
  const int step = params.tile_size - 1;
  if ((terrain.width() - 1) % step == 0 && (terrain.height() - 1) % step == 0) {
    io::write_tiles(terrain, call.path, params.tile_size, options);
  } else {
    io::write_tiles(geom::resample(terrain, tiled_frame(terrain.frame(), params.tile_size), call.run), call.path,
                    params.tile_size, options);
  }
}

struct SplatParams {
  render::Style style = render::Style::natural;
  LayerBorders layers;

  static constexpr auto fields() {
    using P = SplatParams;
    return std::tuple(
        field(&P::style, "style", "of a terrain: the style of the pictures that it goes with; natural: terrain.layers"),
        field(&P::layers, "layers",
              "of a terrain: borders between the low layer (red), the middle (green), the high "
              "(blue)"));
  }
};

void write_splat(const SplatParams& params, const OutputCall& call) {
  if (call.value.kind() == ValueKind::labels) {
    io::write_splat(call.value.regions(), call.path);
    return;
  }
  const HeightField& terrain = call.value.heights();
  geom::Layers layers;
  if (params.style == render::Style::natural) {
    layers = terrain::layers(terrain, params.layers, call.run);
  } else {
    const geom::Borders borders = render::style_borders(params.style, params.layers, terrain);
    layers = geom::height_layers(terrain, borders, params.layers.smooth, params.layers.variation, call.run);
  }
  const std::array<Mask, 3> weights = {std::move(layers.low), std::move(layers.middle), std::move(layers.high)};
  io::write_splat(weights, call.path);
}

template <class Params, Image (*draw)(const HeightField&, const LabelMap*, const Params&, const RunContext&)>
void write_picture(const Params& params, const OutputCall& call) {
  io::write_png(draw(call.value.heights(), call.labels, params, call.run), call.path);
}

void write_relief(const render::ReliefParams& params, const OutputCall& call) {
  io::write_png(render::relief(call.value.heights(), params, call.run), call.path);
}

template <class Params, class Function>
OutputFormat format(OutputFormat row, Function function) {
  row.params = describe_params<Params>();
  row.complete = [](const Json& given, const ReadPlace& place) {
    return write_params(read_params<Params>(given, place));
  };
  row.write = [function](const Json& complete_params, const OutputCall& call) {
    Diagnostics diagnostics;
    const auto params = read_params<Params>(complete_params, {"", diagnostics});
    if (!diagnostics.empty()) throw RecipeError(call.path, diagnostics.items());
    function(params, call);
  };
  return row;
}

/// The sizes that an engine reads are known before anything runs.
template <io::Engine engine>
OutputFormat engine_format(OutputFormat row) {
  row = format<EngineParams>(std::move(row), write_engine<engine>);
  row.complete = [name = row.name](const Json& given, const ReadPlace& place) {
    const auto params = read_params<EngineParams>(given, place);
    const std::vector<int>& sizes = io::engine_sizes(engine);
    if (params.size > 0 && !sizes.empty() && std::find(sizes.begin(), sizes.end(), params.size) == sizes.end()) {
      place.at("size").fail(
          fmt::format("{} is not a size that {} reads; allowed are {}", params.size, name, fmt::join(sizes, ", ")));
    }
    return write_params(params);
  };
  return row;
}

std::vector<OutputFormat> make_formats() {
  using enum ValueKind;
  const std::vector<std::string> rasters = {".tif", ".asc", ".png", ".exr", ".r16", ".raw", ".r32", ".npy"};
  const std::vector<std::string> labelled = {".tif", ".png"};
  const std::vector<std::string> meshes = {".glb", ".obj", ".ply", ".stl"};
  const std::vector<std::string> drawings = {".geojson", ".gpkg", ".svg"};
  const std::vector<std::string> raw16 = {".r16", ".raw", ".png"};
  return {
      format<RasterParams>({"raster",
                            "heights or another scalar: GeoTIFF, ASC, 16-bit PNG, EXR, R16, R32, NPY",
                            rasters,
                            rasters,
                            {terrain, field}},
                           write_raster),
      format<NoParams>({"labels",
                        "regions: GeoTIFF with a palette, or a picture in the colours that can be painted",
                        labelled,
                        labelled,
                        {labels}},
                       [](const NoParams&, const OutputCall& call) { write_raster({}, call); }),
      engine_format<io::Engine::unreal>(
          {"unreal", "16-bit landscape for Unreal Engine, with the scale to type in", raw16, {}, {terrain}}),
      engine_format<io::Engine::unity>(
          {"unity", "16-bit RAW for Unity terrain, with the size to type in", {".raw", ".r16"}, {}, {terrain}}),
      engine_format<io::Engine::godot>(
          {"godot", "EXR in metres for Godot's Terrain3D and HTerrain", {".exr", ".r16"}, {}, {terrain}}),
      engine_format<io::Engine::blender>(
          {"blender", "EXR in metres for a displacement modifier", {".exr"}, {}, {terrain}}),
      format<MeshParams>({"mesh", "triangles: GLB and OBJ with texture, PLY, STL", meshes, meshes, {terrain}},
                         write_mesh),
      format<TilesParams>(
          {"tiles", "tiles that share their border samples and one range of heights", rasters, {}, {terrain}},
          write_tiles),
      format<SplatParams>(
          {"splat",
           "weights that sum to one as RGBA pictures for terrain shaders: the five regions of labels, or "
           "three layers of a terrain by height",
           {".png"},
           {},
           {labels, terrain}},
          write_splat),
      format<render::PerspectiveParams>({"perspective", "a picture with sun, sky and water", {".png"}, {}, {terrain}},
                                        write_picture<render::PerspectiveParams, render::perspective>),
      format<render::MapParams>({"map", "a map with tints, relief, legend and scale bar", {".png"}, {}, {terrain}},
                                write_picture<render::MapParams, render::map>),
      format<render::ReliefParams>({"relief", "shaded relief", {".png"}, {}, {terrain}}, write_relief),
      format<render::TextureParams>({"texture", "the ground from above, for meshes", {".png"}, {}, {terrain}},
                                    write_picture<render::TextureParams, render::texture>),
      format<NoParams>(
          {"drawing", "areas and lines: GeoJSON, GeoPackage, SVG", drawings, drawings, {drawing}},
          [](const NoParams&, const OutputCall& call) { io::write_drawing(call.value.shapes(), call.path); }),
      format<NoParams>({"contours",
                        "contours with their heights, as attribute and as z: GeoPackage, GeoJSON, SVG",
                        drawings,
                        drawings,
                        {contours}},
                       [](const NoParams&, const OutputCall& call) {
                         io::write_drawing(geom::to_lines(call.value.contour_set()), call.path);
                       }),
      format<render::ContoursParams>({"contour_map", "contours as a topographic map", {".png"}, {".png"}, {contours}},
                                     [](const render::ContoursParams& params, const OutputCall& call) {
                                       io::write_png(render::contours(call.value.contour_set(), params, call.run),
                                                     call.path);
                                     }),
      format<NoParams>(
          {"report", "measured numbers: JSON, or a page with plots", {".html", ".json"}, {".html", ".json"}, {report}},
          [](const NoParams&, const OutputCall& call) { io::write_report(call.value.measured(), call.path); }),
      format<NoParams>(
          {"network", "a network as PLY: x, y, z, and of each node its region and rank", {".ply"}, {".ply"}, {tin}},
          [](const NoParams&, const OutputCall& call) { io::write_tin(call.value.network(), call.path); }),
      format<NoParams>({"image", "a picture", {".png"}, {".png"}, {image}},
                       [](const NoParams&, const OutputCall& call) { io::write_png(call.value.picture(), call.path); }),
  };
}

}  // namespace

bool OutputFormat::takes(ValueKind kind) const {
  return std::find(accepts.begin(), accepts.end(), kind) != accepts.end();
}

const std::vector<OutputFormat>& output_formats() {
  static const std::vector<OutputFormat> formats = make_formats();
  return formats;
}

const OutputFormat* find_output_format(std::string_view name) {
  for (const OutputFormat& format : output_formats()) {
    if (format.name == name) return &format;
  }
  return nullptr;
}

const OutputFormat* output_format_for(const std::string& path, ValueKind kind) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const OutputFormat& format : output_formats()) {
    if (format.takes(kind) && std::find(format.claims.begin(), format.claims.end(), extension) != format.claims.end())
      return &format;
  }
  return nullptr;
}

}  // namespace seamount::recipe

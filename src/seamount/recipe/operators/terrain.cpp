// Registration of the terrain family.
#include "seamount/io/raster.h"
#include "seamount/ops/terrain/blend.h"
#include "seamount/ops/terrain/compose.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/ops/terrain/mask.h"
#include "seamount/ops/terrain/noise.h"
#include "seamount/ops/terrain/resample.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

/// terrain.import has no algorithm of its own: it is the raster reader with its options as parameters.
struct ImportParams {
  FilePath file;
  std::optional<double> cell_m;
  std::optional<double> low_m;
  std::optional<double> high_m;
  bool fill_voids = true;
  int band = 1;

  static constexpr auto fields() {
    using P = ImportParams;
    return std::tuple(
        field(&P::file, "file", "GeoTIFF, HGT, ASC, PNG, EXR, R16, R32 or NPY file"),
        field(&P::cell_m, "cell_m", "m", between(1e-4, 1e6), "cell size, where the file does not say"),
        field(&P::low_m, "low_m", "m", between(-20000, 20000), "height of the lowest code of an 8- or 16-bit image"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "height of the highest code of an 8- or 16-bit image"),
        field(&P::fill_voids, "fill_voids", "interpolate cells without data instead of refusing the file"),
        field(&P::band, "band", "", between(1, 1000), "band of a raster with several"));
  }
};

Values import_terrain(const ImportParams& params, const Call& call) {
  if (params.file.path.empty()) throw InvalidArgument("file", "is missing");
  if (params.low_m.has_value() != params.high_m.has_value())
    throw InvalidArgument("low_m", "low_m and high_m go together");
  io::ReadOptions options;
  options.cell_m = params.cell_m;
  if (params.low_m) {
    if (*params.low_m >= *params.high_m)
      throw InvalidArgument("low_m", format_number(*params.low_m) + " is not below high_m");
    options.range = io::HeightRange{*params.low_m, *params.high_m};
  }
  options.voids = params.fill_voids ? io::Voids::fill : io::Voids::refuse;
  options.band = params.band;
  options.run = call.run;
  return {{"terrain", Value::terrain(io::read_heights(call.resolve(params.file), options))}};
}

Values noise(const terrain::NoiseParams& params, const Call& call) {
  return {{"terrain", Value::terrain(terrain::noise(params, call.domain, call.seed, call.run))}};
}

Values blend(const terrain::BlendParams& params, const Call& call) {
  return {{"terrain", Value::terrain(terrain::blend(call.in.at("terrain").heights(), call.in.at("with").heights(),
                                                    call.scalars("mask"), params, call.run))}};
}

Values resample(const terrain::ResampleParams& params, const Call& call) {
  return {
      {"terrain", Value::terrain(terrain::resample(call.in.at("terrain").heights(), params, call.domain, call.run))}};
}

Values mask(const terrain::MaskParams& params, const Call& call) {
  const terrain::MaskInputs in{.terrain = call.in.at("terrain").heights(),
                               .labels = call.labels("labels"),
                               .drawing = call.shapes("drawing"),
                               .values = call.scalars("values"),
                               .mask = call.scalars("mask")};
  return {{"mask", Value::field(terrain::mask(in, params, call.seed, call.run))}};
}

Values layers(const LayerBorders& params, const Call& call) {
  geom::Layers made = terrain::layers(call.in.at("terrain").heights(), params, call.run);
  return {{"low", Value::field(std::move(made.low))},
          {"middle", Value::field(std::move(made.middle))},
          {"high", Value::field(std::move(made.high))}};
}

constexpr int kMostTerrains = 8;

Values compose(const terrain::ComposeParams& params, const Call& call) {
  std::vector<const HeightField*> terrains;
  for (int i = 0; i < kMostTerrains; ++i) {
    if (const Value* terrain = call.input(numbered("terrain", i))) terrains.push_back(&terrain->heights());
  }
  return {{"terrain", Value::terrain(terrain::compose(terrains, params, call.domain, call.run))}};
}

std::vector<Port> compose_ports() {
  std::vector<Port> ports;
  ports.reserve(kMostTerrains);
  for (int i = 0; i < kMostTerrains; ++i) {
    ports.push_back({numbered("terrain", i), ValueKind::terrain,
                     i == 0 ? "the lowest terrain" : "a terrain over those before it", i == 0});
  }
  return ports;
}

}  // namespace

void add_terrain_operators(Registry& registry) {
  const std::vector<Port> out = {{"terrain", ValueKind::terrain, "heights in metres"}};
  registry.add<ImportParams>({.name = "terrain.import",
                              .summary = "A terrain from a file, in metres and square cells",
                              .source = "",
                              .in = {},
                              .out = out},
                             import_terrain);
  registry.add<terrain::NoiseParams>({.name = "terrain.noise",
                                      .summary = "Fractal noise, smooth or ridged",
                                      .source = "Perlin 2002, Musgrave 1994",
                                      .stochastic = true,
                                      .in = {},
                                      .out = out},
                                     noise);
  const Port in{"terrain", ValueKind::terrain, "heights in metres"};
  registry.add<terrain::ResampleParams>({.name = "terrain.resample",
                                         .summary = "A terrain at another cell size, or on the document's domain",
                                         .source = "",
                                         .in = {in},
                                         .out = out},
                                        resample);
  registry.add<terrain::BlendParams>(
      {.name = "terrain.blend",
       .summary = "Two terrains become one: mixed, the higher, the lower, added or subtracted, all over or by a mask",
       .source = "P0 sec. 1.4.2, eq. 1.15 for the smooth maximum",
       .in = {in,
              {"with", ValueKind::terrain, "the second terrain, of the same size"},
              {"mask", ValueKind::field, "where it is done, 0 to 1; everywhere if open", false}},
       .out = out},
      blend);
  registry.add<terrain::ComposeParams>(
      {.name = "terrain.compose",
       .summary = "Several terrains in one domain, moved, turned and scaled, with feathered seams",
       .source = "Porter and Duff 1984",
       .in = compose_ports(),
       .out = out},
      compose);
  registry.add<terrain::MaskParams>(
      {.name = "terrain.mask",
       .summary =
           "A soft selection by height, depth, slope, aspect, curvature, regions, drawn areas and lines, noise or "
           "any field",
       .source = "",
       .stochastic = true,
       .in = {in,
              {"labels", ValueKind::labels, "its regions, for the criterion region", false},
              {"drawing", ValueKind::drawing, "areas and lines, for the criteria area and line", false},
              {"values", ValueKind::field, "any field, for the criterion value", false},
              {"mask", ValueKind::field, "one more mask, combined like a criterion", false}},
       .out = {{"mask", ValueKind::field, "0 where nothing is selected, 1 where all is"}}},
      mask);
  registry.add<LayerBorders>({.name = "terrain.layers",
                              .summary = "How much of each place is low, middle and high ground: three masks that sum "
                                         "to one",
                              .source = "P4 sec. 3.4, eq. 3-6",
                              .in = {in},
                              .out = {{"low", ValueKind::field, "share of the low layer"},
                                      {"middle", ValueKind::field, "share of the middle layer"},
                                      {"high", ValueKind::field, "share of the high layer"}}},
                             layers);
}

}  // namespace seamount::recipe

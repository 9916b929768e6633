// Registration of the terrain family.
#include "seamount/io/raster.h"
#include "seamount/ops/terrain/blend.h"
#include "seamount/ops/terrain/compose.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/ops/terrain/mask.h"
#include "seamount/ops/terrain/noise.h"
#include "seamount/ops/terrain/resample.h"
#include "seamount/ops/terrain/samples.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Field, kinds::Terrain;

const char* const kHeights = "heights in metres";

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

HeightField import_terrain(const ImportParams& params, const Call& call) {
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
  return io::read_heights(call.resolve(params.file), options);
}

std::tuple<ScalarField, ScalarField, ScalarField> layers(const LayerBorders& params, const Call& call,
                                                         const HeightField& terrain) {
  geom::Layers made = terrain::layers(terrain, params, call.run);
  return {std::move(made.low), std::move(made.middle), std::move(made.high)};
}

constexpr int kMostTerrains = 8;

HeightField compose(const terrain::ComposeParams& params, const Call& call,
                    const std::vector<std::tuple<const HeightField*>>& given) {
  std::vector<const HeightField*> terrains;
  terrains.reserve(given.size());
  for (const auto& [terrain] : given) terrains.push_back(terrain);
  return terrain::compose(terrains, params, call.domain, call.run);
}

void add_sources(Registry& registry) {
  registry.add(make_operator<ImportParams>(
      {.name = "terrain.import", .summary = "A terrain from a file, in metres and square cells"}, inputs(),
      outputs(out<Terrain>("terrain", kHeights)), import_terrain));
  registry.add(make_operator<terrain::NoiseParams>({.name = "terrain.noise",
                                                    .summary = "Fractal noise, smooth or ridged",
                                                    .source = "Perlin 2002, Musgrave 1994",
                                                    .stochastic = true},
                                                   inputs(), outputs(out<Terrain>("terrain", kHeights)),
                                                   [](const terrain::NoiseParams& params, const Call& call) {
                                                     return terrain::noise(params, call.domain, call.seed, call.run);
                                                   }));
}

void add_sampling(Registry& registry) {
  registry.add(make_operator<terrain::ResampleParams>(
      {.name = "terrain.resample", .summary = "A terrain at another cell size, or on the document's domain"},
      inputs(in<Terrain>("terrain", kHeights)), outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::ResampleParams& params, const Call& call, const HeightField& terrain) {
        return terrain::resample(terrain, params, call.domain, call.run);
      }));
  registry.add(make_operator<terrain::SamplesParams>(
      {.name = "terrain.samples",
       .revision = 2,
       .summary = "A terrain as the samples that game engines and tiles want, the outer ones on its edge",
       .cached = false},
      inputs(in<Terrain>("terrain", kHeights)), outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::SamplesParams& params, const Call& call, const HeightField& terrain) {
        return terrain::samples(terrain, params, call.run);
      }));
}

void add_joining(Registry& registry) {
  registry.add(make_operator<terrain::BlendParams>(
      {.name = "terrain.blend",
       .summary = "Two terrains become one: mixed, the higher, the lower, added or subtracted, all over or by a mask",
       .source = "P0 sec. 1.4.2, eq. 1.15 for the smooth maximum"},
      inputs(in<Terrain>("terrain", kHeights), in<Terrain>("with", "the second terrain, of the same size"),
             optional_in<Field>("mask", "where it is done, 0 to 1; everywhere if open")),
      outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::BlendParams& params, const Call& call, const HeightField& terrain, const HeightField& with,
         const ScalarField* mask) { return terrain::blend(terrain, with, mask, params, call.run); }));
  registry.add(make_operator<terrain::ComposeParams>(
      {.name = "terrain.compose",
       .summary = "Several terrains in one domain, moved, turned and scaled, with feathered seams",
       .source = "Porter and Duff 1984"},
      inputs(in_rows<Terrain>(kMostTerrains, {"terrain"}, {"the lowest terrain"}, {"a terrain over those before it"})),
      outputs(out<Terrain>("terrain", kHeights)), compose));
}

}  // namespace

void add_terrain_operators(Registry& registry) {
  add_sources(registry);
  add_sampling(registry);
  add_joining(registry);
  registry.add(make_operator<terrain::MaskParams>(
      {.name = "terrain.mask",
       .summary =
           "A soft selection by height, depth, slope, aspect, curvature, regions, drawn areas and lines, noise or "
           "any field",
       .stochastic = true},
      inputs(in<Terrain>("terrain", kHeights),
             optional_in<kinds::Labels>("labels", "its regions, for the criterion region"),
             optional_in<kinds::Drawing>("drawing", "areas and lines, for the criteria area and line"),
             optional_in<Field>("values", "any field, for the criterion value"),
             optional_in<Field>("mask", "one more mask, combined like a criterion")),
      outputs(out<Field>("mask", "0 where nothing is selected, 1 where all is")),
      [](const terrain::MaskParams& params, const Call& call, const HeightField& terrain, const LabelMap* labels,
         const Drawing* drawing, const ScalarField* values, const ScalarField* mask) {
        return terrain::mask({terrain, labels, drawing, values, mask}, params, call.seed, call.run);
      }));
  registry.add(make_operator<LayerBorders>(
      {.name = "terrain.layers",
       .summary = "How much of each place is low, middle and high ground: three masks that sum to one",
       .source = "P4 sec. 3.4, eq. 3-6"},
      inputs(in<Terrain>("terrain", kHeights)),
      outputs(out<Field>("low", "share of the low layer"), out<Field>("middle", "share of the middle layer"),
              out<Field>("high", "share of the high layer")),
      layers));
}

}  // namespace seamount::recipe

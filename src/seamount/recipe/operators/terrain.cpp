// Registration of the terrain family.
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/io/join.h"
#include "seamount/io/raster.h"
#include "seamount/model/extent.h"
#include "seamount/ops/terrain/blend.h"
#include "seamount/ops/terrain/compose.h"
#include "seamount/ops/terrain/crop.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/ops/terrain/mask.h"
#include "seamount/ops/terrain/noise.h"
#include "seamount/ops/terrain/paint.h"
#include "seamount/ops/terrain/resample.h"
#include "seamount/ops/terrain/samples.h"
#include "seamount/ops/terrain/sculpt.h"
#include "seamount/ops/terrain/sea_floor.h"
#include "seamount/ops/terrain/smooth.h"
#include "seamount/ops/terrain/terrace.h"
#include "seamount/recipe/crop_place.h"
#include "seamount/recipe/import_params.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Field, kinds::Terrain;

const char* const kHeights = "heights in metres";
const char* const kOwnPlace = "at its own place";
const char* const kByRelief = "at its own place, once the lowest and the highest of the whole are known";

/// terrain.join: as import, of several files.
struct JoinParams {
  std::vector<FilePath> files;
  std::optional<double> low_m;
  std::optional<double> high_m;
  bool fill_voids = false;
  io::ElevationCoding coding = io::ElevationCoding::numbers;
  std::string unit;
  std::string crs;

  static constexpr auto fields() {
    using P = JoinParams;
    return std::tuple(
        field(&P::files, "files", "neighbouring files that say where they lie; where they overlap the first counts"),
        field(&P::low_m, "low_m", "m", between(-20000, 20000), "height of the lowest code of 8- or 16-bit images"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "height of the highest code of 8- or 16-bit images"),
        field(&P::fill_voids, "fill_voids",
              "give cells without data the heights that the rims of their holes lead to; otherwise they stay unknown"),
        field(&P::coding, "coding",
              "how heights are held: numbers, or in the colours of web map tiles: terrarium, mapbox (Terrain-RGB)"),
        field(&P::unit, "unit", "unit of the heights, such as feet, where the files say none or a wrong one"),
        field(&P::crs, "crs",
              "coordinate system, such as EPSG:4326, where the files say none or a wrong one; local: metres"));
  }
};

HeightField fill_if_asked(HeightField terrain, bool fill, const RunContext& run) {
  if (!fill) return terrain;
  if (const int64_t filled = geom::fill_voids(terrain, run); filled > 0) run.say(filled_note(filled));
  return terrain;
}

HeightField import_terrain(const ImportParams& params, const Call& call) {
  if (params.file.path.empty()) throw InvalidArgument("file", "is missing");
  return fill_if_asked(io::read_heights(call.resolve(params.file), read_options(params, call, call.run.part(0.0, 0.8))),
                       params.fill_voids, call.run.part(0.8, 1.0));
}

HeightField join(const JoinParams& params, const Call& call) {
  if (params.files.empty()) throw InvalidArgument("files", "names no file");
  ImportParams common;
  common.low_m = params.low_m;
  common.high_m = params.high_m;
  common.coding = params.coding;
  common.unit = params.unit;
  common.crs = params.crs;
  std::vector<std::string> paths;
  for (const FilePath& file : params.files) paths.push_back(call.resolve(file));
  return fill_if_asked(io::read_joined_heights(paths, read_options(common, call, call.run.part(0.0, 0.8))),
                       params.fill_voids, call.run.part(0.8, 1.0));
}

std::tuple<ScalarField, ScalarField, ScalarField> layers(const LayerBorders& params, const Call& call,
                                                         const HeightField& terrain) {
  geom::Layers made = terrain::layers(terrain, params, call.run, call.whole);
  return {std::move(made.low), std::move(made.middle), std::move(made.high)};
}

constexpr int kMostTerrains = 8;

HeightField compose(const terrain::ComposeParams& params, const Call& call,
                    const std::vector<std::tuple<const HeightField*>>& given) {
  std::vector<const HeightField*> terrains;
  terrains.reserve(given.size());
  for (const auto& [terrain] : given) terrains.push_back(terrain);
  // A document that says nothing of its size takes that of terrains which lie where they lie.
  const bool as_they_lie = !call.domain_stated && params.places.empty() && !terrains.empty();
  const GridFrame frame = as_they_lie ? terrain::frame_around(terrains) : call.domain;
  return terrain::compose(terrains, params, frame, call.run);
}

void add_sources(Registry& registry) {
  registry.add(make_operator<ImportParams>({.name = "terrain.import",
                                            .revision = 2,
                                            .summary = "A terrain from a file, in metres and square cells",
                                            .in_tiles = "a GeoTIFF window by window"},
                                           inputs(), outputs(out<Terrain>("terrain", kHeights)), import_terrain));
  registry.add(make_operator<JoinParams>(
      {.name = "terrain.join", .summary = "Neighbouring files of elevation as one terrain, cell by cell"}, inputs(),
      outputs(out<Terrain>("terrain", kHeights)), join));
  registry.add(make_operator<terrain::NoiseParams>(
      {.name = "terrain.noise",
       .summary = "Fractal noise: mountains with valleys, smooth or ridged",
       .source = "Perlin 2002, Musgrave 1994",
       .stochastic = true,
       .looks = "smooth and ridged: at its own place; mountains: some 5 wavelength_m around"},
      inputs(), outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::NoiseParams& params, const Call& call) {
        return terrain::noise(params, call.domain, call.seed, call.run);
      },
      terrain::noise_reach));
}

void add_sampling(Registry& registry) {
  registry.add(make_operator<terrain::ResampleParams>(
      {.name = "terrain.resample",
       .revision = 2,
       .summary = "A terrain at another cell size, or on the document's domain",
       .looks = "at everything; with centre off and beyond edge at its own place in the domain, at the whole terrain",
       .in_tiles = "window by window"},
      inputs(with_voids(placed(Placing::system, in<Terrain>("terrain", kHeights)))),
      outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::ResampleParams& params, const Call& call, const HeightField& terrain) {
        return terrain::resample(terrain, params, call.domain, call.run);
      },
      [](const terrain::ResampleParams& params, double) { return terrain::resample_reach(params); }));
  registry.add(make_operator<terrain::SeaFloorParams>(
      {.name = "terrain.sea_floor",
       .summary = "A plausible sea floor for elevation models of land, whose sea is 0 m everywhere"},
      inputs(in<Terrain>("terrain", kHeights)), outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::SeaFloorParams& params, const Call& call, const HeightField& terrain) {
        return terrain::sea_floor(terrain, params, call.run);
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

HeightField crop(const terrain::CropParams& params, const Call& call, const HeightField& terrain) {
  return terrain::crop(terrain, in_metres(params, terrain.frame()), call.run);
}

void add_shaping(Registry& registry) {
  registry.add(make_operator<terrain::CropParams>(
      {.name = "terrain.crop",
       .summary = "A part of a terrain around a place, its summit or its middle, where it lies",
       .in_tiles = "window by window"},
      inputs(with_voids(placed(Placing::system, in<Terrain>("terrain", kHeights)))),
      outputs(out<Terrain>("terrain", kHeights)), crop));
  registry.add(make_operator<terrain::SmoothParams>(
      {.name = "terrain.smooth",
       .revision = 2,
       .summary = "A terrain with its detail taken off or exaggerated, all over or by a mask",
       .looks = "3 radius_m around"},
      inputs(in<Terrain>("terrain", kHeights),
             optional_in<Field>("mask", "where it is done, 0 to 1; everywhere if open")),
      outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::SmoothParams& params, const Call& call, const HeightField& terrain, const ScalarField* mask) {
        return terrain::smooth(terrain, mask, params, call.run);
      },
      terrain::smooth_reach));
  registry.add(make_operator<terrain::TerraceParams>(
      {.name = "terrain.terrace",
       .summary = "Slopes become treads and risers, as where hard beds lie in soft ones; erosion makes walls of them",
       .stochastic = true,
       .looks = kOwnPlace},
      inputs(in<Terrain>("terrain", kHeights),
             optional_in<Field>("mask", "where it is done, 0 to 1; everywhere if open")),
      outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::TerraceParams& params, const Call& call, const HeightField& terrain, const ScalarField* mask) {
        return terrain::terrace(terrain, mask, params, call.seed, call.run);
      },
      [](const terrain::TerraceParams&, double) { return Reach::place(); }));
}

/// What a pen draws.
void add_drawing(Registry& registry) {
  registry.add(make_operator<terrain::SculptParams>(
      {.name = "terrain.sculpt",
       .revision = 3,
       .summary = "Strokes of a pen raise, lower, smooth, flatten, slope, roughen the ground, and are erased",
       .stochastic = true,
       .looks = "at its own place; with smooth, and with flatten and ramp without stated heights, at everything"},
      inputs(with_voids(in<Terrain>("terrain", kHeights)),
             optional_in<Field>("mask", "where it is done, 0 to 1; everywhere if open")),
      outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::SculptParams& params, const Call& call, const HeightField& terrain, const ScalarField* mask) {
        return terrain::sculpt(terrain, mask, params, call.seed, call.run, call.whole);
      },
      [](const terrain::SculptParams& params, double) { return terrain::sculpt_reach(params); }));
  registry.add(make_operator<terrain::PaintParams>(
      {.name = "terrain.paint",
       .summary = "A field painted with a pen: a mask, a density, a hardness, where ground is to be made anew",
       .looks = kOwnPlace},
      inputs(with_voids(optional_in<Field>("values", "what is painted on; `base` everywhere if open")),
             with_voids(optional_in<Terrain>("terrain", "where the field is to lie; its heights do not count"))),
      outputs(out<Field>("values", "the painted field")),
      [](const terrain::PaintParams& params, const Call& call, const ScalarField* values, const HeightField* terrain) {
        const GridFrame& frame = values != nullptr    ? values->frame()
                                 : terrain != nullptr ? terrain->frame()
                                                      : call.domain;
        return terrain::paint(frame, values, params, call.run, call.whole);
      },
      [](const terrain::PaintParams&, double) { return Reach::place(); }));
}

void add_joining(Registry& registry) {
  registry.add(make_operator<terrain::BlendParams>(
      {.name = "terrain.blend",
       .summary = "Two terrains become one: mixed, the higher, the lower, added or subtracted, all over or by a mask",
       .source = "P0 sec. 1.4.2, eq. 1.15 for the smooth maximum",
       .looks = kOwnPlace},
      inputs(with_voids(in<Terrain>("terrain", kHeights)),
             with_voids(in<Terrain>("with", "the second terrain, of the same size")),
             optional_in<Field>("mask", "where it is done, 0 to 1; everywhere if open")),
      outputs(out<Terrain>("terrain", kHeights)),
      [](const terrain::BlendParams& params, const Call& call, const HeightField& terrain, const HeightField& with,
         const ScalarField* mask) { return terrain::blend(terrain, with, mask, params, call.run); },
      [](const terrain::BlendParams&, double) { return Reach::place(); }));
  registry.add(make_operator<terrain::ComposeParams>(
      {.name = "terrain.compose",
       .revision = 2,
       .summary = "Several terrains in one domain, moved, turned and scaled, with feathered seams",
       .source = "Porter and Duff 1984",
       .looks = "at everything; with places and outside_m at its own place in the domain, at the whole terrains"},
      inputs(with_voids(placed(Placing::system, in_rows<Terrain>(kMostTerrains, {"terrain"}, {"the lowest terrain"},
                                                                 {"a terrain over those before it"})))),
      outputs(out<Terrain>("terrain", kHeights)), compose,
      [](const terrain::ComposeParams& params, double) { return terrain::compose_reach(params); }));
}

}  // namespace

void add_terrain_operators(Registry& registry) {
  add_sources(registry);
  add_sampling(registry);
  add_joining(registry);
  add_shaping(registry);
  add_drawing(registry);
  registry.add(make_operator<terrain::MaskParams>(
      {.name = "terrain.mask",
       .revision = 3,
       .summary =
           "A soft selection by height, depth, slope, aspect, curvature, regions, drawn areas and lines, noise or "
           "any field",
       .stochastic = true,
       .looks = "at its own place; with slope, aspect and curvature 2 scale_m around, with region as far as its "
                "limits; with depth, and where heights are unknown with slope, aspect and curvature, at everything",
       .in_tiles = "depth over their borders"},
      inputs(with_voids(in<Terrain>("terrain", kHeights)),
             optional_in<kinds::Labels>("labels", "its regions, for the criterion region"),
             optional_in<kinds::Drawing>("drawing", "areas and lines, for the criteria area and line"),
             with_voids(optional_in<Field>("values", "any field, for the criterion value")),
             with_voids(optional_in<Field>("mask", "one more mask, combined like a criterion"))),
      outputs(out<Field>("mask", "`low` (0) where nothing is selected, `high` (1) where all is")),
      [](const terrain::MaskParams& params, const Call& call, const HeightField& terrain, const LabelMap* labels,
         const Drawing* drawing, const ScalarField* values, const ScalarField* mask) {
        return terrain::mask({terrain, labels, drawing, values, mask}, params, call.seed, call.run);
      },
      terrain::mask_reach));
  registry.add(settled_by_relief<LayerBorders>(
      make_operator<LayerBorders>(
          {.name = "terrain.layers",
           .revision = 2,
           .summary = "How much of each place is low, middle and high ground: three masks that sum to one",
           .source = "P4 sec. 3.4, eq. 3-6",
           .looks = kByRelief},
          inputs(in<Terrain>("terrain", kHeights)),
          outputs(out<Field>("low", "share of the low layer"), out<Field>("middle", "share of the middle layer"),
                  out<Field>("high", "share of the high layer")),
          layers, [](const LayerBorders& params, double) { return geom::layers_reach(params); }),
      [](const LayerBorders& params, float lowest, float highest) {
        return geom::stated(params, geom::relief_borders(params, lowest, highest));
      }));
}

}  // namespace seamount::recipe

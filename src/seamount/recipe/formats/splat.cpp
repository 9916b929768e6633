// Splat maps of terrains, by height, and of labels, by region.
#include "seamount/io/splat.h"

#include "seamount/io/engine.h"
#include "seamount/ops/render/splat_layers.h"
#include "seamount/ops/terrain/samples.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/engine_fit.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

/// Whose sizes and squares the map has; any: those of the terrain, or any that are asked for.
enum class SplatFor { any, unreal, unity, godot, blender };

}  // namespace
}  // namespace seamount::recipe

template <>
struct seamount::Choices<seamount::recipe::SplatFor> {
  static constexpr std::array<std::string_view, 5> names = {"any", "unreal", "unity", "godot", "blender"};
};

namespace seamount::recipe {
namespace {

struct SplatParams {
  SplatFor engine = SplatFor::any;
  int size = 0;
  Fit fit = Fit::by_engine;
  io::SplatFiles files = io::SplatFiles::grey;
  std::optional<double> soft_m;
  render::Style style = render::Style::natural;
  LayerBorders layers;

  static constexpr auto fields() {
    using P = SplatParams;
    return std::tuple(
        field(&P::engine, "engine", "the engine whose height map it goes with: the same size and fit"),
        field(&P::size, "size", "", between(0, 16385),
              "samples a side, as of the height map; 0: as many as the engine's height map of this terrain has"),
        field(&P::fit, "fit", kFitMeaning),
        field(&P::files, "files",
              "grey: a picture for each layer, NAME_low.png and so on; rgba: three layers in one, alpha opaque"),
        field(&P::soft_m, "soft_m", "m", between(0, 100000),
              "width over which neighbouring layers mix; four cells if absent, 0: hard borders of regions and shores"),
        field(&P::style, "style",
              "of a terrain: the style of the pictures that it goes with; natural: borders at shares of the land's "
              "relief"),
        field(&P::layers, "layers", "of a terrain: borders between the low, the middle and the high layer"));
  }
};

bool is_labels(const Kind& kind) { return &kind == &kinds::Labels::kind(); }

const std::vector<int>& sizes_of(SplatFor engine) {
  static const std::vector<int> kAny;
  return engine == SplatFor::any ? kAny : io::engine_sizes(static_cast<io::Engine>(static_cast<int>(engine) - 1));
}

Json samples_of(const SplatParams& params) { return samples_params(params.size, params.fit, sizes_of(params.engine)); }

void write_splat(const SplatParams& params, const OutputCall& call) {
  const io::SplatOptions options{.files = params.files, .provenance = call.provenance};
  if (call.value.is<kinds::Labels>()) {
    const auto& labels = call.value.get<kinds::Labels>();
    const GridFrame frame =
        terrain::samples_frame(labels.frame(), read_complete<terrain::SamplesParams>(samples_of(params)));
    io::write_splat(render::splat_layers(labels, frame, params.soft_m, call.run), call.path, options, call.run);
    return;
  }
  const auto& ground = call.value.get<kinds::Terrain>();
  io::SplatOptions with_land = options;
  with_land.ground = &ground;
  io::write_splat(render::splat_layers(ground, {params.style, params.layers}, params.soft_m, call.run), call.path,
                  with_land, call.run);
}

}  // namespace

void add_splat_format(Registry& registry) {
  OutputFormat format =
      make_format<SplatParams>({"splat",
                                "weights of ground layers that sum to one, for terrain shaders: a grey picture for "
                                "each of the five regions of labels, or of a terrain's low, middle and high ground "
                                "and its seabed",
                                {".png"},
                                {},
                                {&kinds::Labels::kind(), &kinds::Terrain::kind()}},
                               write_splat);
  format.complete = [](const Json& given, const ReadPlace& place) {
    const auto params = read_params<SplatParams>(given, place);
    check_fit(params.size, params.fit, sizes_of(params.engine),
              Choices<SplatFor>::names[static_cast<size_t>(params.engine)], place);
    return write_params(params);
  };
  format.prepare = [](const Json& params, const Kind& kind, const std::string&) -> std::vector<Preparation> {
    if (is_labels(kind)) return {};
    return {{"", "terrain.samples", "terrain", samples_of(read_complete<SplatParams>(params))}};
  };
  format.files = [](const Json& params, const Kind& kind, const std::string& path) {
    return io::splat_files(is_labels(kind) ? render::region_layer_names() : render::terrain_layer_names(), path,
                           read_complete<SplatParams>(params).files);
  };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

// Height maps for engines: terrain.samples brings the terrain to their samples.
#include "seamount/io/engine.h"

#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/engine_fit.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

struct EngineParams {
  int size = 0;
  Fit fit = Fit::by_engine;
  std::optional<double> low_m;
  std::optional<double> high_m;

  static constexpr auto fields() {
    using P = EngineParams;
    return std::tuple(
        field(&P::size, "size", "", between(0, 16385),
              "samples a side; 0: the largest that the engine takes and the terrain fills"),
        field(&P::fit, "fit", kFitMeaning),
        field(&P::low_m, "low_m", "m", between(-20000, 20000),
              "height of the lowest code; chosen with room to sculpt if absent"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000), "height of the highest code; chosen if absent"));
  }
};

/// An engine's format. The sizes that it reads are known before anything runs.
void add_engine(Registry& registry, io::Engine engine, OutputFormat row) {
  row.accepts = {&kinds::Terrain::kind()};
  OutputFormat format =
      make_format<EngineParams>(std::move(row), [engine](const EngineParams& p, const OutputCall& call) {
        io::write_for_engine(call.value.get<kinds::Terrain>(), engine, call.path,
                             {.range = height_range(p.low_m, p.high_m), .provenance = call.provenance});
      });
  const std::vector<int>& sizes = io::engine_sizes(engine);
  format.complete = [&sizes, name = format.name](const Json& given, const ReadPlace& place) {
    const auto params = read_params<EngineParams>(given, place);
    check_fit(params.size, params.fit, sizes, name, place);
    return write_params(params);
  };
  format.prepare = [&sizes](const Json& params, const Kind&, const std::string&) -> std::vector<Preparation> {
    const auto read = read_complete<EngineParams>(params);
    return {{"", "terrain.samples", "terrain", samples_params(read.size, read.fit, sizes)}};
  };
  format.files = [](const Json&, const Kind&, const std::string& path) -> std::vector<std::string> {
    return {path, io::sidecar_path(path)};
  };
  registry.add(std::move(format));
}

}  // namespace

void add_engine_formats(Registry& registry) {
  using enum io::Engine;
  add_engine(
      registry, unreal,
      {"unreal", "16-bit landscape for Unreal Engine, with the scale to type in", {".r16", ".raw", ".png"}, {}, {}});
  add_engine(registry, unity,
             {"unity", "16-bit RAW for Unity terrain, with the size to type in", {".raw", ".r16"}, {}, {}});
  add_engine(registry, godot, {"godot", "EXR in metres for Godot's Terrain3D and HTerrain", {".exr", ".r16"}, {}, {}});
  add_engine(registry, blender, {"blender", "EXR in metres for a displacement modifier", {".exr"}, {}, {}});
}

}  // namespace seamount::recipe

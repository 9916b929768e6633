#include "seamount/io/splat.h"

#include <array>
#include <filesystem>

#include "seamount/ops/render/layers.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

bool is_labels(const Kind& kind) { return &kind == &kinds::Labels::kind(); }

void write_splat(const render::LayersParams&, const OutputCall& call) {
  if (call.value.is<kinds::Labels>()) {
    io::write_splat(call.value.get<kinds::Labels>(), call.path);
    return;
  }
  const auto weight = [&](const char* name) { return call.prepared.find(name)->second.get<kinds::Field>(); };
  const std::array<Mask, 3> weights = {weight("low"), weight("middle"), weight("high")};
  io::write_splat(weights, call.path);
}

}  // namespace

void add_splat_format(Registry& registry) {
  OutputFormat format = make_format<render::LayersParams>(
      {"splat",
       "weights that sum to one as RGBA pictures for terrain shaders: the five regions of labels, or "
       "three layers of a terrain by height",
       {".png"},
       {},
       {&kinds::Labels::kind(), &kinds::Terrain::kind()}},
      write_splat);
  format.prepare = [](const Json& params, const Kind& kind, const std::string&) -> std::vector<Preparation> {
    if (is_labels(kind)) return {};
    std::vector<Preparation> layers;
    for (const char* name : {"low", "middle", "high"}) layers.push_back({name, "render.layers", name, params});
    return layers;
  };
  format.files = [](const Json&, const Kind& kind, const std::string& path) -> std::vector<std::string> {
    if (!is_labels(kind)) return {path};
    const std::string stem = std::filesystem::path(path).replace_extension().string();
    return {stem + "_0.png", stem + "_1.png"};  // four materials each
  };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

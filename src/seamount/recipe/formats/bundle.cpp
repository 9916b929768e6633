// Everything that an engine needs of a terrain, in one folder: height map, layers, texture, and the numbers to type in.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "seamount/io/atomic_file.h"
#include "seamount/io/engine.h"
#include "seamount/io/image_file.h"
#include "seamount/io/sidecar.h"
#include "seamount/io/splat.h"
#include "seamount/io/texture_part.h"
#include "seamount/ops/render/splat_layers.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/engine_fit.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;
using Ordered = nlohmann::ordered_json;

struct BundleParams {
  io::Engine engine = io::Engine::unreal;
  int size = 0;
  Fit fit = Fit::by_engine;
  std::optional<double> low_m;
  std::optional<double> high_m;
  int texture_px = 2048;
  std::optional<double> soft_m;
  render::Style style = render::Style::natural;
  LayerBorders layers;

  static constexpr auto fields() {
    using P = BundleParams;
    return std::tuple(
        field(&P::engine, "engine", "whose formats, sizes and numbers"),
        field(&P::size, "size", "", between(0, 16385),
              "samples a side of height map and layers; 0: the largest that the engine takes and the terrain fills"),
        field(&P::fit, "fit", kFitMeaning),
        field(&P::low_m, "low_m", "m", between(-20000, 20000),
              "16-bit height maps: height of the lowest code; chosen with room to sculpt if absent"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000),
              "16-bit height maps: height of the highest code; chosen if absent"),
        field(&P::texture_px, "texture_px", "", between(0, 16384),
              "size of the colours along the terrain's longer side; 0: none"),
        field(&P::soft_m, "soft_m", "m", between(0, 100000),
              "width over which neighbouring layers mix; four cells if absent"),
        field(&P::style, "style", "what colours and layers are made of: natural, or three layers by height in a style"),
        field(&P::layers, "layers", "borders between the low, the middle and the high layer"));
  }
};

std::string_view engine_name(io::Engine engine) { return Choices<io::Engine>::names[static_cast<size_t>(engine)]; }

std::string height_file(io::Engine engine, const std::string& folder) {
  static constexpr std::array<const char*, 4> kFiles = {"height.r16", "height.raw", "height.exr", "height.exr"};
  return folder + "/" + kFiles[static_cast<size_t>(engine)];
}
std::string layer_path(const std::string& folder) { return folder + "/layer.png"; }
std::string texture_file(const std::string& folder) { return folder + "/texture.png"; }
std::string text_file(const std::string& folder) { return folder + "/import.txt"; }
std::string json_file(const std::string& folder) { return folder + "/import.json"; }

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::string hundredths(double metres) { return format_number(std::round(metres * 100) / 100 + 0.0); }

/// What a person does in each engine with the files.
const char* steps_of(io::Engine engine) {
  switch (engine) {
    case io::Engine::unreal:
      return "Landscape mode > New > Import from file, then the numbers below. Each grey layer file goes to a layer "
             "of\n"
             "the landscape material: in Paint mode right-click the layer > Import from file.";
    case io::Engine::unity:
      return "Terrain settings > Import Raw with the numbers below. The layer files are grey masks of terrain layers,\n"
             "north on top as Unity shows pictures; the height map's own first row is the southern one.";
    case io::Engine::godot:
      return "Import the height map in Terrain3D or HTerrain with the numbers below. The layer files are grey masks,\n"
             "the texture is a colour map of the same ground.";
    case io::Engine::blender:
      return "Add > Mesh > Grid with the numbers below, a Displace modifier with the height map, and the texture as\n"
             "image texture over the grid's UVs. The layer files mix materials (Non-Color).";
  }
  return "";
}

std::string told(const Ordered& json, const BundleParams& params) {
  std::string text = fmt::format("Terrain for {}, made by {}\n\n{}\n\n", engine_name(params.engine),
                                 json["made_by"].get<std::string>(), steps_of(params.engine));
  const Ordered& height = json["height"];
  text +=
      fmt::format("height map  {}, {} x {} samples of {} m\n", height["file"].get<std::string>(),
                  height["width"].get<int>(), height["height"].get<int>(), hundredths(height["cell_m"].get<double>()));
  text += fmt::format("heights     {} m to {} m, sea level is 0 m\n\n", hundredths(height["min_m"].get<double>()),
                      hundredths(height["max_m"].get<double>()));
  for (const auto& [place, value] : height["numbers"].items())
    text += fmt::format("  {:<26}  {}\n", place, value.get<std::string>());
  text += "\n";
  for (const Ordered& layer : json["layers"])
    text += fmt::format("layer       {:<8}  {} ({} % of the land)\n", layer["name"].get<std::string>(),
                        layer["file"].get<std::string>(), format_number(layer["percent_of_land"].get<double>()));
  if (json.contains("texture"))
    text += fmt::format("texture     {}, {} x {} pixels\n", json["texture"]["file"].get<std::string>(),
                        json["texture"]["width"].get<int>(), json["texture"]["height"].get<int>());
  return text;
}

Ordered height_numbers(const std::string& file) {
  const io::Sidecar sidecar = *io::read_sidecar(file);
  Ordered json = {{"file", file_name(file)},
                  {"width", sidecar.frame.width},
                  {"height", sidecar.frame.height},
                  {"cell_m", sidecar.frame.cell_m},
                  {"first_row", sidecar.south_first ? "south" : "north"},
                  {"min_m", sidecar.min_m},
                  {"max_m", sidecar.max_m}};
  if (sidecar.range) json["low_m"] = sidecar.range->low_m, json["high_m"] = sidecar.range->high_m;
  json["numbers"] = Ordered::object();
  for (const auto& [place, value] : sidecar.import) json["numbers"][place] = value;
  return json;
}

void write_bundle(const BundleParams& params, const OutputCall& call) {
  const std::string& folder = call.path;
  const auto& samples = call.prepared.find("samples")->second.get<kinds::Terrain>();
  const std::string height = height_file(params.engine, folder);
  io::write_for_engine(samples, params.engine, height,
                       {.range = height_range(params.low_m, params.high_m), .provenance = call.provenance});
  io::write_splat(render::splat_layers(samples, {params.style, params.layers}, params.soft_m, call.run),
                  layer_path(folder), {.ground = &samples, .provenance = call.provenance}, call.run);
  const std::vector<uint8_t> list = io::read_file(io::splat_list(layer_path(folder)));
  Ordered json = {{"seamount", "bundle"},
                  {"engine", engine_name(params.engine)},
                  {"made_by", call.provenance.program},
                  {"height", height_numbers(height)},
                  {"layers", Ordered::parse(list.begin(), list.end())["layers"]}};
  const auto texture = call.prepared.find("texture");
  if (texture != call.prepared.end()) {
    const GridFrame& whole = call.value.get<kinds::Terrain>().frame();
    const Image& picture = texture->second.get<kinds::Image>();
    // A plane in Blender is as large as the cells.
    const Image part = params.engine == io::Engine::blender ? io::texture_over(picture, whole, samples.frame())
                                                            : io::texture_between(picture, whole, samples.frame());
    io::write_png(part, texture_file(folder));
    json["texture"] = {{"file", file_name(texture_file(folder))}, {"width", part.width}, {"height", part.height}};
  }
  io::write_text(json_file(folder), json.dump(1, ' ', false, Ordered::error_handler_t::replace) + "\n");
  io::write_text(text_file(folder), told(json, params));
  call.run.say(fmt::format("{} holds the numbers to type in", file_name(text_file(folder))));
}

std::vector<Preparation> prepare(const Json& given, const Kind&, const std::string&) {
  const auto params = read_complete<BundleParams>(given);
  std::vector<Preparation> all = {{"samples", "terrain.samples", "terrain",
                                   samples_params(params.size, params.fit, io::engine_sizes(params.engine))}};
  if (params.texture_px > 0)
    all.push_back({"texture",
                   "render.texture",
                   "image",
                   {{"size_px", std::max(16, params.texture_px)},
                    {"water_clarity", 5.0},
                    {"style", given["style"]},
                    {"layers", given["layers"]}}});
  return all;
}

std::vector<std::string> files(const Json& given, const Kind&, const std::string& folder) {
  const auto params = read_complete<BundleParams>(given);
  std::vector<std::string> all = {text_file(folder), json_file(folder), height_file(params.engine, folder)};
  all.push_back(io::sidecar_path(all.back()));
  const auto layers = io::splat_files(render::terrain_layer_names(), layer_path(folder), io::SplatFiles::grey);
  all.insert(all.end(), layers.begin(), layers.end());
  if (params.texture_px > 0) all.push_back(texture_file(folder));
  return all;
}

}  // namespace

void add_bundle_format(Registry& registry) {
  OutputFormat format = make_format<BundleParams>({"bundle",
                                                   "a folder with all that an engine needs: height map, ground layers, "
                                                   "colours, and the numbers to type in",
                                                   {""},
                                                   {},
                                                   {&kinds::Terrain::kind()}},
                                                  write_bundle);
  format.complete = [](const Json& given, const ReadPlace& place) {
    const auto params = read_params<BundleParams>(given, place);
    check_fit(params.size, params.fit, io::engine_sizes(params.engine), engine_name(params.engine), place);
    return write_params(params);
  };
  format.prepare = prepare;
  format.files = files;
  registry.add(std::move(format));
}

}  // namespace seamount::recipe

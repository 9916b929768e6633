// A call of any operator with inputs that fit it, for tests and benchmarks over all of them.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "seamount/ops/ecosystem/grow.h"
#include "seamount/recipe/executor.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {

/// How large examples are.
struct Extent {
  int width;
  int height;
  int particles;
};
inline GridFrame frame_of(const Extent& extent) {
  return GridFrame::centred(extent.width, extent.height, 9600.0 / extent.width);
}

/// A hill of three levels with a second summit.
inline ContourSet example_contours(const GridFrame& frame) {
  const auto circle = [](Vec2 middle, double radius) {
    Ring ring;
    for (int i = 0; i < 48; ++i)
      ring.push_back(middle + radius * Vec2{std::cos(i * 0.1308996938996), std::sin(i * 0.1308996938996)});
    return ring;
  };
  return {frame,
          {{0, circle({}, 3300), -1},
           {100, circle({-200, 100}, 2600), 0},
           {200, circle({-1200, 100}, 1000), 1},
           {200, circle({1200, 100}, 900), 1}}};
}

/// An island, corals that give off sand, and a reef that follows it.
inline seamount::Catalogue example_catalogue() {
  seamount::Catalogue catalogue;
  catalogue.materials.push_back({.name = "sand", .density = 0.1, .flow_coupling = 1.0, .decay_1_s = 0.001});
  const auto add = [&](const char* name, SkeletonKind skeleton, const char* fitness) -> ObjectClass& {
    ObjectClass of;
    of.name = name;
    of.skeleton = skeleton;
    of.fitness = fitness;
    of.death = -1000.0;
    of.shape.length_m = 800.0;
    of.shape.area_m2 = 200000.0;
    of.shape.steps = 5;
    of.placement.samples = 256;
    catalogue.classes.push_back(std::move(of));
    return catalogue.classes.back();
  };
  add("lagoon", SkeletonKind::region, "1 + bell(depth, 20, 20) + 0.1 * noise(900)").label = {LabelChoice::lagoon, 0.0};
  ObjectClass& coral = add("coral", SkeletonKind::point, "1 + bell(depth, 10, 10) - 0.1 * sand");
  coral.placement.per_iteration = 30;
  coral.deposits = {{"sand", 0.1, 100.0}};
  coral.height = {HeightShape::bump, HeightGroup::surface, 2.0, 200.0, 0.5};
  coral.currents = {{CurrentShape::scale, 0.1, 100.0}};
  add("reef", SkeletonKind::curve, "1 + sand").label = {LabelChoice::reef, 200.0};
  return catalogue;
}

inline Scene example_scene(const HeightField& ground) {
  const seamount::Catalogue catalogue = example_catalogue();
  ecosystem::GrowParams params;
  params.iterations = 2;
  return ecosystem::grow({ground, &catalogue}, params, Seed{4}, {}).scene;
}

inline Values make_example_values(const Extent& extent) {
  const GridFrame frame = frame_of(extent);
  const Json recipe = {
      {"seamount", 1},
      {"domain", {{"width_m", frame.width_m()}, {"height_m", frame.height_m()}, {"cell_m", frame.cell_m}}},
      {"steps",
       {{{"id", "isle"}, {"op", "island.build"}},
        {{"id", "lines"}, {"op", "island.outlines"}, {"in", {{"labels", "isle.labels"}}}},
        {{"id", "grown"}, {"op", "contour.grow"}, {"params", {{"particles", extent.particles}}}},
        {{"id", "grove"},
         {"op", "ecosystem.scatter"},
         {"in", {{"terrain", "isle.terrain"}}},
         {"params", {{"spacing_m", 500}}}},
        {{"id", "network"}, {"op", "contour.heights"}, {"in", {{"tin", "grown.tin"}}}}}}};
  const std::vector<Source> wanted = {{"isle", "terrain", ""},   {"isle", "labels", ""}, {"isle", "coordinate", ""},
                                      {"lines", "outlines", ""}, {"network", "tin", ""}, {"grove", "things", ""}};
  const std::vector<Value> made = evaluate(parse_recipe(recipe.dump(), "example", ""), wanted, {"", ""}, {});
  return Values{{"terrain", made[0]},
                {"labels", made[1]},
                {"field", made[2]},
                {"drawing", made[3]},
                {"tin", made[4]},
                {"things", made[5]},
                {"current", Value::of<kinds::Current>({ScalarField(frame, 0.4F), ScalarField(frame, -0.3F)})},
                {"image", Value::of<kinds::Image>(Image(8, 8))},
                {"contours", Value::of<kinds::Contours>(example_contours(frame))},
                {"catalogue", Value::of<kinds::Catalogue>(example_catalogue())},
                {"objects", Value::of<kinds::Objects>(example_scene(made[0].get<kinds::Terrain>()))}};
}

/// An island whose values fit any port.
inline const Values& example_values(const Extent& extent) {
  static std::map<int, Values> made;
  const auto found = made.find(extent.width);
  return found != made.end() ? found->second : made.emplace(extent.width, make_example_values(extent)).first->second;
}

/// Optional inputs of which an operator needs one.
inline const std::map<std::string, std::string>& needed_inputs() {
  static const std::map<std::string, std::string> needed = {{"learned.island", "labels"},
                                                            {"contour.extract", "terrain"},
                                                            {"contour.refine", "tin"},
                                                            {"contour.reconstruct", "contours"},
                                                            {"ecosystem.grow", "catalogue"}};
  return needed;
}

/// A call with every required input.
class ExampleCall {
 public:
  /// Pictures are small unless `full_pictures`.
  explicit ExampleCall(const Operator& op, const Extent& extent, bool full_pictures = false)
      : domain_(frame_of(extent)) {
    for (const Port& port : op.in) {
      const auto needed = needed_inputs().find(op.name);
      const bool given = port.required || (needed != needed_inputs().end() && needed->second == port.name);
      if (given) in_[port.name] = example_values(extent).at(port.kind->name);
    }
    params_ = op.complete(Json::object(), {"", diagnostics_});
    if (op.name == "terrain.import") params_["file"] = file(extent);
    if (op.name == "terrain.join") params_["files"] = {file(extent)};
    if (params_.contains("fill_voids")) params_["fill_voids"] = true;
    if (op.name == "drawing.import" || op.name == "contour.import") params_["file"] = sheet_file(extent);
    if (op.name == "ecosystem.grow") params_["iterations"] = 2;
    if (op.name == "ecosystem.field") params_["of"] = "depth - sand + noise(500)";
    if (op.name == "terrain.mask") give("criteria", R"([{"tool": "slope"}, {"tool": "height"}])");
    if (op.name == "terrain.sculpt") give("strokes", kSculpting);
    if (op.name == "terrain.paint") give("strokes", kPainting);
    if (op.name == "classify.paint") give("strokes", kRegions);
    if (op.name == "contour.edit") give("edits", R"([{"tool": "smooth"}, {"tool": "smooth", "rounds": 1}])");
    if (op.name == "island.wind") give("radial_count", "5");
    if (params_.contains("particles") && op.name != "reef.grow") params_["particles"] = extent.particles;
    if (full_pictures) return;
    for (const auto& [name, pixels] : {std::pair{"width_px", 160}, {"height_px", 90}, {"size_px", 64}}) {
      if (params_.contains(name)) params_[name] = pixels;
    }
  }
  Values run(const Operator& op, Seed seed, const RunContext& context) const {
    return op.run(params_, in_, {domain_, true, seed, folder_, context});
  }
  Json& params() { return params_; }

 private:
  static constexpr const char* kSculpting = R"([
    {"tool": "raise", "points": [[-3000, 0], [0, 900], [2000, -800]], "pressure": [0.2, 1, 0.5], "radius_m": 900},
    {"tool": "smooth", "points": [[-2000, 500], [2500, 700]], "radius_m": 700},
    {"tool": "flatten", "points": [[1000, -2000], [-2500, -1500]], "radius_m": 800, "hardness": 0.5},
    {"tool": "ramp", "points": [[-3000, 2000], [0, 2500]]},
    {"tool": "roughen", "points": [[0, 0], [3000, 3000]], "radius_m": 1200},
    {"tool": "erase", "points": [[0, -4000], [0, 4000]], "radius_m": 300}])";

  static constexpr const char* kPainting = R"([
    {"tool": "brush", "points": [[-3000, 0], [0, 900], [2000, -800]], "pressure": [0.2, 1, 0.5], "radius_m": 900},
    {"tool": "area", "polygons": [[[0, 0], [3000, 500], [1000, 3000]]], "value": 0.5, "feather_m": 400},
    {"tool": "erase", "points": [[0, -4000], [0, 4000]], "radius_m": 300}])";
  static constexpr const char* kRegions = R"([
    {"tool": "region", "region": "reef", "points": [[-3000, 0], [0, 900], [2000, -800]], "radius_m": 1900},
    {"tool": "area", "region": "beach", "polygons": [[[0, 0], [3000, 500], [1000, 3000]]]},
    {"tool": "sink", "points": [[-2000, 0], [2000, 400]], "pressure": [0.2, 1], "subsidence": 0.7},
    {"tool": "erase", "points": [[0, -4000], [0, 4000]], "radius_m": 300}])";

  void give(const char* param, const char* text) { params_[param] = Json::parse(text); }

  /// A raster with a hole that is filled.
  static std::string file(const Extent& extent) {
    const std::string path = (std::filesystem::temp_directory_path() / "seamount_example.asc").string();
    std::ofstream out(path);
    out << "ncols " << extent.width << "\nnrows " << extent.height
        << "\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9\n";
    for (int y = 0; y < extent.height; ++y) {
      for (int x = 0; x < extent.width; ++x) out << (std::abs(x - 40) + std::abs(y - 30) < 12 ? -9 : x % 50 + y) << ' ';
      out << '\n';
    }
    return path;
  }

  /// Contour lines of a plane that rises eastwards, from the southern to the northern edge.
  static std::string sheet_file(const Extent& extent) {
    const std::string path = (std::filesystem::temp_directory_path() / "seamount_example.geojson").string();
    std::ofstream out(path);
    out << R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32604"}},"features":[)";
    for (int i = 0; i < 9; ++i) {
      out << (i == 0 ? "" : ",") << R"({"type":"Feature","properties":{"ELEV":)" << 20 * i
          << R"(},"geometry":{"type":"LineString","coordinates":[)";
      for (int k = 0; k <= extent.height; ++k)
        out << (k == 0 ? "" : ",") << '[' << 500000 + 1000 * i + 10 * (k % 2) << ',' << 9000.0 * k / extent.height
            << ']';
      out << "]}}";
    }
    out << "]}\n";
    return path;
  }
  GridFrame domain_;
  Values in_;
  std::string folder_;
  Diagnostics diagnostics_;
  Json params_;
};

}  // namespace seamount::recipe

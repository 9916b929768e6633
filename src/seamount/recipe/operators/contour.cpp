// Registration of the contour family: which files and inputs become regions, and which ports the operators have.
#include <algorithm>
#include <filesystem>

#include "seamount/io/image_file.h"
#include "seamount/io/vector.h"
#include "seamount/ops/contour/edit/edit.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/growth/probability.h"
#include "seamount/ops/contour/growth/rivers.h"
#include "seamount/ops/contour/heights/heights.h"
#include "seamount/ops/contour/refine/refine.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

const Port kContoursIn{"contours", ValueKind::contours, "nested closed contours"};
const Port kContoursOut{"contours", ValueKind::contours, "nested closed contours"};

bool is_picture(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

/// The one thing that growth starts from, of those that were given; a random land where nothing was. A drawing in a
/// coordinate system of its own lends it to the frame.
contour::RegionTree make_regions(const contour::GrowParams& p, const Call& call, GridFrame& frame) {
  std::vector<std::string> given;
  if (!p.outlines.empty()) given.emplace_back("outlines");
  if (!p.regions.path.empty()) given.emplace_back("regions");
  for (const char* input : {"regions", "contours", "mask"}) {
    if (call.input(input) != nullptr) given.push_back("the input '" + std::string(input) + "'");
  }
  if (given.size() > 1)
    throw InvalidArgument(given[0], "given together with " + given[1] + "; growth starts from one of them");
  const contour::PaintedRegions painted{.darkest_is_land = p.darkest_is_land};
  const auto from_drawing = [&](const Drawing& drawing) {
    if (!drawing.crs.empty()) frame.crs = drawing.crs;
    return contour::regions_from_drawing(drawing, frame, "regions");
  };
  if (!p.outlines.empty()) return contour::regions_from_outlines(p.outlines, frame, "outlines");
  if (const Drawing* drawing = call.shapes("regions")) return from_drawing(*drawing);
  if (const Value* contours = call.input("contours"))
    return contour::regions_from_contours(contours->contour_set(), frame, "contours", call.run);
  if (const ScalarField* mask = call.scalars("mask"))
    return contour::regions_from_mask(*mask, frame, painted, "mask", call.run);
  if (p.regions.path.empty()) return contour::random_region(frame, call.seed);
  const std::string path = call.resolve(p.regions);
  if (is_picture(path)) return contour::regions_from_image(io::read_image(path), frame, painted, "regions", call.run);
  return from_drawing(io::read_drawing(path, {.feature = p.feature, .layer = {}}));
}

Values grow(const contour::GrowParams& params, const Call& call) {
  GridFrame frame = call.domain;
  const contour::RegionTree tree = make_regions(params, call, frame);
  const ScalarField* probability = call.scalars("probability");
  ScalarField painted;
  if (!params.probability_picture.path.empty()) {
    if (probability != nullptr)
      throw InvalidArgument("probability_picture", "given together with the input 'probability'; growth follows one");
    painted = contour::painted_probability(io::read_image(call.resolve(params.probability_picture)), frame);
    probability = &painted;
  }
  const Drawing* drawn = call.shapes("rivers");
  const std::vector<RiverLine> rivers = drawn == nullptr ? std::vector<RiverLine>{} : contour::river_lines(*drawn);
  return {{"tin", Value::tin(contour::grow(tree, frame, probability, rivers, params, call.seed, call.run))}};
}

Values heights(const contour::HeightsParams& params, const Call& call) {
  const Value* terrain = call.input("terrain");
  return {{"tin", Value::tin(contour::heights(call.in.at("tin").network(),
                                              terrain == nullptr ? nullptr : &terrain->heights(), params, call.run))}};
}

Values refine(const contour::RefineParams& params, const Call& call) {
  const Value* tin = call.input("tin");
  const Value* contours = call.input("contours");
  if ((tin == nullptr) == (contours == nullptr))
    throw IncompatibleInputs(std::string("connect either 'tin' or 'contours'") +
                             (tin == nullptr ? "; neither is" : ", not both"));
  contour::RefineInputs inputs{call.scalars("probability"), {}};
  if (const Drawing* rivers = call.shapes("rivers")) inputs.rivers = contour::river_lines(*rivers);
  return {{"tin",
           Value::tin(tin != nullptr ? contour::refine(tin->network(), inputs, params, call.seed, call.run)
                                     : contour::refine(contours->contour_set(), inputs, params, call.seed, call.run))}};
}

Values edit(const contour::EditParams& params, const Call& call) {
  const auto read_file = [&call](const FilePath& file) { return io::read_drawing(call.resolve(file)); };
  const contour::PatternSource patterns{call.shapes("pattern"), read_file};
  return {{"contours", Value::contours(contour::edit(call.in.at("contours").contour_set(), params, patterns, call.seed,
                                                     call.run))}};
}

Values pattern(const contour::PatternParams& params, const Call& call) {
  return {{"pattern", Value::drawing(contour::pattern(call.in.at("contours").contour_set(), params, call.run))}};
}

}  // namespace

void add_contour_operators(Registry& registry) {
  registry.add<contour::GrowParams>(
      {.name = "contour.grow",
       .revision = 3,
       .summary = "Grows nested regions into a network whose nodes know in which order they rise, without basins",
       .source = "P2 sec. 4.2, 4.3, 4.5, Algorithm 1",
       .stochastic = true,
       .in = {{"regions", ValueKind::drawing, "nested areas or closed lines; a line's value is its height", false},
              {"contours", ValueKind::contours, "contours whose insides are the regions", false},
              {"mask", ValueKind::field, "a picture of nested regions, darker lower, laid over the domain", false},
              {"probability", ValueKind::field, "in [0, 1]: where it is high growth runs ahead and cuts valleys",
               false},
              {"rivers", ValueKind::drawing, "lines from source to mouth, with their beds and widths as numbers",
               false}},
       .out = {{"tin", ValueKind::tin, "a network with a rank per node and no heights yet"}}},
      grow);
  registry.add<contour::HeightsParams>(
      {.name = "contour.heights",
       .revision = 2,
       .summary = "Heights for a grown network from a distribution of heights, through outlines of given height",
       .source = "P2 sec. 3.3, 4.4, fig. 8, 23",
       .in = {{"tin", ValueKind::tin, "a network as contour.grow makes it"},
              {"terrain", ValueKind::terrain, "measured for its distribution of heights", false}},
       .out = {{"tin", ValueKind::tin, "the same network with a height per node"}}},
      heights);
  registry.add<contour::RefineParams>(
      {.name = "contour.refine",
       .revision = 2,
       .summary = "Makes a network finer pass by pass, between its own contours, which keep their places and heights",
       .source = "P2 sec. 6.6",
       .stochastic = true,
       .in = {{"tin", ValueKind::tin, "a network with heights", false},
              {"contours", ValueKind::contours, "or nested closed contours", false},
              {"probability", ValueKind::field, "in [0, 1]: where it is high growth runs ahead and cuts valleys",
               false},
              {"rivers", ValueKind::drawing, "lines from source to mouth, with their beds and widths as numbers",
               false}},
       .out = {{"tin", ValueKind::tin, "a finer network with heights, whose regions are the contours that were held"}}},
      refine);
  registry.add<contour::EditParams>(
      {.name = "contour.edit",
       .summary = "Edits contours by a list of tools that can be replayed; they never come to cross",
       .source = "P2 sec. 5 and 6.6",
       .stochastic = true,
       .in = {kContoursIn,
              {"pattern", ValueKind::drawing, "pasted where nothing was copied and no file is named", false}},
       .out = {kContoursOut}},
      edit);
  registry.add<contour::PatternParams>(
      {.name = "contour.pattern",
       .summary = "The contours within an outline as a small drawing, to be stored and pasted elsewhere",
       .source = "P2 sec. 6.2",
       .in = {kContoursIn},
       .out = {{"pattern", ValueKind::drawing, "the outline and the lines within it, heights above the outline's"}}},
      pattern);
}

}  // namespace seamount::recipe

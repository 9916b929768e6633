// Registration of the contour family.
#include <optional>

#include "seamount/io/image_file.h"
#include "seamount/io/vector.h"
#include "seamount/model/extent.h"
#include "seamount/ops/contour/edit/edit.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/growth/choose_regions.h"
#include "seamount/ops/contour/growth/rivers.h"
#include "seamount/ops/contour/heights/heights.h"
#include "seamount/ops/contour/refine/refine.h"
#include "seamount/recipe/degrees.h"
#include "seamount/recipe/file_values.h"
#include "seamount/recipe/one_frame.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Contours, kinds::Field, kinds::Terrain;

const char* const kNested = "nested closed contours";
const char* const kProbability = "in [0, 1]: where it is high growth runs ahead and cuts valleys";
const char* const kRivers = "lines from source to mouth, with their beds and widths as numbers";

Tin grow(const contour::GrowParams& params, const Call& call, const Drawing* regions, const ContourSet* contours,
         const ScalarField* mask, const ScalarField* probability, const Drawing* rivers) {
  GridFrame domain = call.domain;
  std::optional<contour::RegionFile> file;
  if (!params.regions.path.empty()) {
    const std::string path = call.resolve(params.regions);
    if (is_picture(path))
      file = io::read_image(path);
    else
      file = bring_drawing(io::read_drawing(path,
                                            {.feature = params.feature,
                                             .layer = params.layer,
                                             .height_field = params.height_field,
                                             .crs = params.crs},
                                            call.run),
                           domain, path);
  }
  const auto read_regions = [&](const FilePath&) { return *file; };
  const auto read_picture = [&](const FilePath& picture) { return io::read_image(call.resolve(picture)); };
  return contour::grow({regions, contours, mask, probability, rivers, read_regions, read_picture}, params, domain,
                       call.seed, call.run);
}

Tin refine(const contour::RefineParams& params, const Call& call, const Tin* tin, const ContourSet* contours,
           const ScalarField* probability, const Drawing* rivers) {
  contour::RefineInputs inputs{probability, {}};
  if (rivers != nullptr) inputs.rivers = contour::river_lines(*rivers);
  return contour::refine(tin, contours, inputs, params, call.seed, call.run);
}

ContourSet edit(const contour::EditParams& params, const Call& call, const ContourSet& contours,
                const Drawing* pattern) {
  const auto read_file = [&call](const FilePath& file) { return io::read_drawing(call.resolve(file), {}, call.run); };
  contour::EditParams placed = params;
  for (size_t i = 0; i < placed.edits.size(); ++i) {
    auto* paste = std::get_if<contour::PasteTool>(&placed.edits[i]);
    if (paste == nullptr) continue;
    const std::string name = "edits[" + std::to_string(i) + "].";
    if (const auto place = place_in_metres({paste->longitude_deg, paste->latitude_deg}, paste->at.has_value(),
                                           contours.frame, name, "at")) {
      if (!Extent::of(contours.frame).contains(*place))
        throw InvalidArgument(name + "longitude_deg", degrees_text(Vec2{*paste->longitude_deg, *paste->latitude_deg}) +
                                                          " lies outside the domain, which covers " +
                                                          degrees_text(contours.frame));
      paste->at = place;
    }
  }
  return contour::edit(contours, placed, {pattern, read_file}, call.seed, call.run);
}

void add_growth(Registry& registry) {
  registry.add(make_operator<contour::GrowParams>(
      {.name = "contour.grow",
       .revision = 6,
       .summary = "Grows nested regions into a network whose nodes know in which order they rise, without basins",
       .source = "P2 sec. 4.2, 4.3, 4.5, Algorithm 1",
       .stochastic = true},
      inputs(optional_in<kinds::Drawing>("regions", "nested areas or closed lines; a line's value is its height"),
             optional_in<Contours>("contours", "contours whose insides are the regions"),
             optional_in<Field>("mask", "a picture of nested regions, darker lower, laid over the domain"),
             optional_in<Field>("probability", kProbability), optional_in<kinds::Drawing>("rivers", kRivers)),
      outputs(out<kinds::Tin>("tin", "a network with a rank per node and no heights yet")), grow));
  registry.add(make_operator<contour::HeightsParams>(
      {.name = "contour.heights",
       .revision = 3,
       .summary = "Heights for a grown network from a distribution of heights, through outlines of given height",
       .source = "P2 sec. 3.3, 4.4, fig. 8, 23"},
      inputs(in<kinds::Tin>("tin", "a network as contour.grow makes it"),
             placed(Placing::anywhere, optional_in<Terrain>("terrain", "measured for its distribution of heights"))),
      outputs(out<kinds::Tin>("tin", "the same network with a height per node")),
      [](const contour::HeightsParams& params, const Call& call, const Tin& tin, const HeightField* terrain) {
        return contour::heights(tin, terrain, params, call.run);
      }));
  registry.add(make_operator<contour::RefineParams>(
      {.name = "contour.refine",
       .revision = 3,
       .summary = "Makes a network finer pass by pass, between its own contours, which keep their places and heights",
       .source = "P2 sec. 6.6",
       .stochastic = true,
       .needs_one = true},
      inputs(optional_in<kinds::Tin>("tin", "a network with heights"),
             optional_in<Contours>("contours", "or nested closed contours"),
             optional_in<Field>("probability", kProbability), optional_in<kinds::Drawing>("rivers", kRivers)),
      outputs(out<kinds::Tin>("tin", "a finer network with heights, whose regions are the contours that were held")),
      refine));
}

}  // namespace

void add_contour_operators(Registry& registry) {
  add_growth(registry);
  registry.add(make_operator<contour::EditParams>(
      {.name = "contour.edit",
       .revision = 4,
       .summary = "Edits contours by a list of tools that can be replayed; they never come to cross",
       .source = "P2 sec. 5 and 6.6",
       .stochastic = true},
      inputs(in<Contours>("contours", kNested),
             placed(Placing::anywhere,
                    optional_in<kinds::Drawing>("pattern", "pasted where nothing was copied and no file is named"))),
      outputs(out<Contours>("contours", kNested)), edit));
  registry.add(make_operator<contour::PatternParams>(
      {.name = "contour.pattern",
       .summary = "The contours within an outline as a small drawing, to be stored and pasted elsewhere",
       .source = "P2 sec. 6.2"},
      inputs(in<Contours>("contours", kNested)),
      outputs(out<kinds::Drawing>("pattern", "the outline and the lines within it, heights above the outline's")),
      [](const contour::PatternParams& params, const Call& call, const ContourSet& contours) {
        return contour::pattern(contours, params, call.run);
      }));
}

}  // namespace seamount::recipe

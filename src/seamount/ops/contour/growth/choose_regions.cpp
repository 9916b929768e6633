#include "seamount/ops/contour/growth/choose_regions.h"

#include "seamount/base/inputs.h"
#include "seamount/ops/contour/growth/probability.h"
#include "seamount/ops/contour/growth/rivers.h"

namespace seamount::contour {

RegionTree choose_regions(const GrowParams& p, const GrowInputs& inputs, GridFrame& frame, Seed seed,
                          const RunContext& run) {
  std::vector<std::string> given;
  if (!p.outlines.empty()) given.emplace_back("outlines");
  if (!p.regions.path.empty()) given.emplace_back("regions");
  if (inputs.regions != nullptr) given.emplace_back("the input 'regions'");
  if (inputs.contours != nullptr) given.emplace_back("the input 'contours'");
  if (inputs.mask != nullptr) given.emplace_back("the input 'mask'");
  refuse_several(given, "growth starts from one of them");
  const PaintedRegions painted{.darkest_is_land = p.darkest_is_land};
  const auto from_drawing = [&](const Drawing& drawing) {
    if (!drawing.crs.empty()) frame.crs = drawing.crs;
    return regions_from_drawing(drawing, frame, "regions");
  };
  if (!p.outlines.empty()) return regions_from_outlines(p.outlines, frame, "outlines");
  if (inputs.regions != nullptr) return from_drawing(*inputs.regions);
  if (inputs.contours != nullptr) return regions_from_contours(*inputs.contours, frame, "contours");
  if (inputs.mask != nullptr) return regions_from_mask(*inputs.mask, frame, painted, "mask", run);
  if (p.regions.path.empty()) return random_region(frame, seed);
  if (!inputs.read_regions) throw InvalidArgument("regions", "is a file, and nothing was given to read it with");
  const RegionFile file = inputs.read_regions(p.regions);
  if (const auto* picture = std::get_if<Image>(&file))
    return regions_from_image(*picture, frame, painted, "regions", run);
  return from_drawing(std::get<Drawing>(file));
}

Tin grow(const GrowInputs& inputs, const GrowParams& params, const GridFrame& domain, Seed seed,
         const RunContext& run) {
  GridFrame frame = domain;
  RegionTree tree = choose_regions(params, inputs, frame, seed, run);
  const ScalarField* probability = inputs.probability;
  ScalarField painted;
  if (!params.probability_picture.path.empty()) {
    if (probability != nullptr)
      throw InvalidArgument("probability_picture", "given together with the input 'probability'; growth follows one");
    if (!inputs.read_picture)
      throw InvalidArgument("probability_picture", "is a file, and nothing was given to read it with");
    painted = painted_probability(inputs.read_picture(params.probability_picture), frame);
    probability = &painted;
  }
  std::vector<RiverLine> rivers;
  if (inputs.rivers != nullptr) rivers = river_lines(*inputs.rivers);
  return grow(std::move(tree), frame, probability, std::move(rivers), params, seed, run);
}

}  // namespace seamount::contour

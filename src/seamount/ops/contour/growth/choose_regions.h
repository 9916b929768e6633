// What contours grow from: the one thing that was given, or a random land.
#pragma once

#include <functional>
#include <variant>

#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/image.h"
#include "seamount/ops/contour/growth/grow.h"

namespace seamount::contour {

/// What a file of regions holds: areas and closed lines, or a picture whose grey levels are nested regions.
using RegionFile = std::variant<Drawing, Image>;

/// What growth reads besides its parameters.
struct GrowInputs {
  const Drawing* regions = nullptr;                              ///< nested areas or closed lines
  const ContourSet* contours = nullptr;                          ///< contours whose insides are the regions
  const ScalarField* mask = nullptr;                             ///< a picture of nested regions, laid over the domain
  const ScalarField* probability = nullptr;                      ///< as in grow()
  const Drawing* rivers = nullptr;                               ///< lines from source to mouth (river_lines())
  std::function<RegionFile(const FilePath&)> read_regions = {};  ///< for `regions`
  std::function<Image(const FilePath&)> read_picture = {};       ///< for `probability_picture`
};

/// The regions of the one thing that is given: outlines or regions of the params, the inputs regions, contours or mask;
/// a random land where nothing is. A drawing in a coordinate system of its own lends it to the frame. Throws
/// InvalidArgument for more than one, and what the builders of regions.h throw.
RegionTree choose_regions(const GrowParams& params, const GrowInputs& inputs, GridFrame& frame, Seed seed,
                          const RunContext& run);

/// The network that grows from them. Throws what choose_regions and grow throw, and InvalidArgument for two
/// probabilities.
Tin grow(const GrowInputs& inputs, const GrowParams& params, const GridFrame& domain, Seed seed, const RunContext& run);

}  // namespace seamount::contour

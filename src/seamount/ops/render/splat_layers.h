// The layers of a splat map: low, middle and high ground over the sea and the seabed below it, or the regions of
// labels, with borders as soft as a painter would make them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/ground_layer.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/render/layers.h"

namespace seamount::render {

/// Names of the layers of a terrain and of labels, in their order.
std::vector<std::string> terrain_layer_names();
std::vector<std::string> region_layer_names();

/// low, middle and high of layers() where a terrain is above 0 m, and "seabed" below. Borders are mixed over about
/// `soft_m` metres (from a tenth to nine tenths of a layer; absent: four cells; 0: borders by height alone, and a
/// hard shore). Weights sum to one to float rounding. Throws as layers(), and InvalidArgument{soft_m} below 0.
std::vector<GroundLayer> splat_layers(const HeightField& terrain, const LayersParams& params,
                                      std::optional<double> soft_m, const RunContext& run);

/// The five regions on a frame; beyond the labels their edge goes on. Where cells are larger than the labels' each
/// region has its share of the cell. Throws InvalidArgument{labels} without cells, {soft_m}. Parallel.
std::vector<GroundLayer> splat_layers(const LabelMap& labels, const GridFrame& frame, std::optional<double> soft_m,
                                      const RunContext& run);

}  // namespace seamount::render

// Relief shading for maps: how light each cell is drawn, 1 on level ground.
//
// Light from several directions around the main one, weighted so that the main one rules (after Mark,
// "Multidirectional, oblique-weighted, shaded-relief image of the island of Hawaii", USGS OFR 92-422), on the terrain
// itself and on a smoothed copy, so that large forms read through the detail (Imhof, Cartographic Relief Presentation,
// 1982, ch. 9); darkened where little sky is seen. Shadow sides are softened: nothing goes black.
#pragma once

#include <optional>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::render {

struct ShadingOptions {
  double light_azimuth = 5.4978;       ///< radians clockwise from north: north-west
  double light_elevation = 0.785;      ///< radians
  std::optional<double> exaggeration;  ///< of heights; absent: so that steep ground of this terrain looks steep
  double ambient = 0.6;                ///< strength of the sky's part, [0, 1]
};

/// Lightness of each cell, about [0.35, 1.35]. Parallel; about 100 ns a cell, twelve grids of memory.
Grid<float> relief_shading(const HeightField& terrain, const ShadingOptions& options, const RunContext& run);

}  // namespace seamount::render

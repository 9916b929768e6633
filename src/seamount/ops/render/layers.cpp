#include "seamount/ops/render/layers.h"

#include <algorithm>

namespace seamount::render {

Reach layers_reach(const LayersParams& params) {
  if (params.style != Style::natural)
    return Reach::everything("the borders of a style are shares of the relief; natural with stated ones has others");
  return geom::layers_reach(params.layers);
}

geom::Layers layers(const HeightField& terrain, const LayersParams& params, const RunContext& run) {
  check_params(params);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  run.check_cancelled();
  const LayerBorders& given = params.layers;
  const geom::Borders borders = params.style == Style::natural ? geom::relief_borders(given, terrain)
                                                               : style_borders(params.style, given, terrain);
  return geom::height_layers(terrain, borders, given.smooth, given.variation, run);
}

}  // namespace seamount::render

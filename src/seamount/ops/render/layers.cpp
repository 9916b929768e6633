#include "seamount/ops/render/layers.h"

#include <algorithm>

namespace seamount::render {

LayersParams settled_layers(const LayersParams& params, float lowest_m, float highest_m) {
  const geom::Borders borders = params.style == Style::natural
                                    ? geom::relief_borders(params.layers, lowest_m, highest_m)
                                    : style_borders(params.style, params.layers, lowest_m, highest_m);
  return {params.style, geom::stated(params.layers, borders)};
}

geom::Layers layers(const HeightField& terrain, const LayersParams& params, const RunContext& run,
                    const GridFrame* whole) {
  check_params(params);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  run.check_cancelled();
  const LayerBorders& given = params.layers;
  const geom::Borders borders = params.style == Style::natural ? geom::relief_borders(given, terrain)
                                                               : style_borders(params.style, given, terrain);
  return geom::height_layers(terrain, borders, given.smooth, given.variation, run, whole);
}

}  // namespace seamount::render

#include "seamount/ops/terrain/layers.h"

namespace seamount::terrain {

geom::Layers layers(const HeightField& terrain, const LayerBorders& params, const RunContext& run,
                    const GridFrame* whole) {
  check_params(params);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  run.check_cancelled();
  return geom::height_layers(terrain, geom::relief_borders(params, terrain), params.smooth, params.variation, run,
                             whole);
}

}  // namespace seamount::terrain

#include "seamount/ops/terrain/layers.h"

#include <algorithm>

namespace seamount::terrain {

geom::Layers layers(const HeightField& terrain, const LayerBorders& params, const RunContext& run) {
  check_params(params);
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  run.check_cancelled();
  const auto [bottom, top] = std::minmax_element(terrain.cells().begin(), terrain.cells().end());
  return geom::height_layers(terrain, geom::resolve_borders(params, *bottom, *top), params.smooth, params.variation,
                             run);
}

}  // namespace seamount::terrain

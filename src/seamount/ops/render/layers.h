// render.layers: the layers of ground that a style's pictures show, as three masks that sum to one, for splat maps.
//
// Source: P4 sec. 3.4, eq. 3 to 6 (geom/grid/height_layers.h); the styles are in style.h.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/grid/height_layers.h"
#include "seamount/model/grid.h"
#include "seamount/model/layer_borders.h"
#include "seamount/ops/render/style.h"

namespace seamount::render {

struct LayersParams {
  Style style = Style::natural;
  LayerBorders layers;

  static constexpr auto fields() {
    using P = LayersParams;
    return std::tuple(field(&P::style, "style",
                            "the style of the pictures that it goes with; natural: borders at shares of the relief, as "
                            "terrain.layers"),
                      field(&P::layers, "layers",
                            "borders between the low layer (red), the middle (green), the high "
                            "(blue)"));
  }
};

/// The layers of a terrain in a style. Throws InvalidArgument for params out of range and a high border below the low
/// one. `whole`: the frame of which the terrain is a window; null: none. Parallel; about 25 ns per cell.
geom::Layers layers(const HeightField& terrain, const LayersParams& params, const RunContext& run,
                    const GridFrame* whole = nullptr);

/// The parameters with the borders that they have on a terrain between two heights.
LayersParams settled_layers(const LayersParams& params, float lowest_m, float highest_m);

}  // namespace seamount::render

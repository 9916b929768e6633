// terrain.layers: how much of each cell is low, middle and high ground: three masks that sum to one, for splat maps,
// for scattering, or as inputs of steps that treat each layer in its own way.
//
// Source: P4 sec. 3.4, eq. 3 to 6 (geom/grid/height_layers.h). Pictures drawn in a style and splat maps show these
// layers.
#pragma once

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/grid/height_layers.h"
#include "seamount/model/grid.h"
#include "seamount/model/layer_borders.h"

namespace seamount::terrain {

/// The layers of a terrain; borders that are absent are shares of the relief between its lowest cell, or sea level
/// where it has land and sea, and its highest.
/// Throws InvalidArgument for params out of range and a high border below the low one. Parallel; about 25 ns per cell.
/// `whole`: the frame of which the terrain is a window; null: none.
geom::Layers layers(const HeightField& terrain, const LayerBorders& params, const RunContext& run,
                    const GridFrame* whole = nullptr);

}  // namespace seamount::terrain

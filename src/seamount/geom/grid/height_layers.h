// Three ground layers blended by height: how much of a cell is low, middle and high ground.
//
// Source: P4 sec. 3.4, eq. 3 to 6 in metres. Departures, each of which can be turned off: layers fade by a smoothstep
// of eq. 5 instead of eq. 5 itself, whose kinks show as edges; and the borders stray from one height by noise, and away
// from the middle layer on steep ground, since borders along contours look like bands.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/layer_borders.h"
#include "seamount/model/reach.h"

namespace seamount::geom {

/// Borders and their errors in metres, all known.
struct Borders {
  double low_m = 0.0, low_error_m = 0.0;
  double high_m = 0.0, high_error_m = 0.0;
};

/// What is absent becomes the paper's share of the relief between `bottom_m` and `top_m`: borders at 0.3 and 0.5,
/// errors of 0.1 and 0.05. Throws InvalidArgument{high_m} where high_m lies below low_m.
Borders resolve_borders(const LayerBorders& borders, double bottom_m, double top_m);
/// The same with the relief of a terrain: from its lowest to its highest cell, or from sea level where it has land and
/// sea: the depth of the water says nothing of what grows on an island. REQUIRES: it has cells.
Borders relief_borders(const LayerBorders& borders, const HeightField& terrain);
Borders relief_borders(const LayerBorders& borders, float lowest_m, float highest_m);

/// Parameters that state them.
inline LayerBorders stated(const LayerBorders& params, const Borders& borders) {
  return {borders.low_m, borders.low_error_m, borders.high_m, borders.high_error_m, params.smooth, params.variation};
}

/// P_error (eq. 5): 1 at no distance, 0 from `error` on. REQUIRES: distance >= 0.
double error_pass(double distance, double error);
/// P_low (eq. 3) and P_high (eq. 4).
double low_pass(double height, double border, double error);
double high_pass(double height, double border, double error);

/// Shares of the three layers; they sum to one.
struct LayerShares {
  double low = 0.0, middle = 0.0, high = 0.0;
};

/// Eq. 6: low first, then high, the middle takes the rest.
LayerShares layer_shares(double height, const Borders& borders);

/// The same per cell.
struct Layers {
  Mask low, middle, high;
};

/// Layers of a terrain. `smooth` and `variation` as in LayerBorders; without both exactly layer_shares(height). The
/// noise hangs on the place in metres and on how large the terrain is. low + middle + high = 1 to float rounding, each
/// in [0, 1]. `whole`: the frame of which the terrain is a window; null: none. Parallel; about 20 ns per cell.
Layers height_layers(const HeightField& terrain, const Borders& borders, bool smooth, double variation,
                     const RunContext& run, const GridFrame* whole = nullptr);

/// How far the layers look with borders that shares of the relief stand in for where they are absent.
Reach layers_reach(const LayerBorders& borders);

}  // namespace seamount::geom

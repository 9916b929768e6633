// terrain.sculpt: strokes of a pen that raise, lower, smooth, flatten, slope and roughen the ground, replayed in their
// order.
//
// A stroke is a sweep of its brush along a spline (geom/brush/brush_rows.h): each place gets about the greatest of
// pressure times profile along the way, so a stroke that crosses itself does not count twice; one stroke after another
// does. All is set in metres, so that coarse cells show what fine ones do. With w the weight, times that of the mask:
//
//   raise, lower   z +- w height                 smooth   z + w strength (G z - z), Gaussian G of a third of the radius
//   flatten, ramp  z + w strength (level - z)    roughen  z + w amplitude noise, one field of noise for all strokes
//   erase          z + w strength (z0 - z), z0 the ground as it came in
//
// A ramp's level runs evenly in the direction from the stroke's beginning to its end. "The ground" at an end is its
// mean under the brush when the stroke's turn comes. What of a stroke lies outside the terrain does not count: it
// begins where it comes within reach.
#pragma once

#include <tuple>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/reach.h"
#include "seamount/ops/terrain/sculpt_tools.h"

namespace seamount::terrain {

struct SculptParams {
  std::vector<SculptStroke> strokes;

  static constexpr auto fields() {
    return std::tuple(field(&SculptParams::strokes, "strokes", "what the pen does, one stroke after another"));
  }
};

/// The ground after all strokes; ground out of their reach stays to the bit, unknown cells (NaN) stay unknown. `mask`
/// may be null: everywhere; values beyond [0, 1] count as the nearer end. Throws InvalidArgument{"strokes[i]..."} for
/// params out of range, a stroke without points or with other than one pressure each; IncompatibleInputs for a mask of
/// another size. Parallel; 1000 strokes of 30 points over 256 x 256 in 30 ms; cost follows the cells under strokes, and
/// those within a radius of where it is smoothed. `whole`: the frame of which the terrain is a window; null: none.
HeightField sculpt(const HeightField& terrain, const Mask* mask, const SculptParams& params, Seed seed,
                   const RunContext& run, const GridFrame* whole = nullptr);

/// At its own place, unless a stroke looks at the ground as it is when its turn comes.
Reach sculpt_reach(const SculptParams& params);

}  // namespace seamount::terrain

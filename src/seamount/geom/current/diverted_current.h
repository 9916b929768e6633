// A current that the ground turns aside (P3 eq. 1.51 to 1.53, after Paris et al. 2019).
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/vector_field.h"

namespace seamount::geom {

/// One of the sizes of forms that the current goes round.
struct DiversionScale {
  double sigma_m = 200.0;   ///< deviation of the blur, >= 0
  double weight = 0.8;      ///< of this size in the sum, >= 0
  double deviation = 30.0;  ///< how fast the current runs along a slope: times its speed times the slope, >= 0

  bool operator==(const DiversionScale&) const = default;
};

struct DiversionOptions {
  Vec2 base_m_s;               ///< the current where nothing is in its way
  double venturi_per_m = 0.0;  ///< k_w, >= 0: the base grows by this share a metre of depth (or height)
  std::vector<DiversionScale> scales = {{200.0, 0.8, 30.0}, {50.0, 0.2, 5.0}};
  double shallows_m = 0.0;  ///< depth below which the current weakens, to nothing on dry land; 0: it crosses land too
  double most_gain = 3.0;   ///< a current along a slope is at most this many times as fast as the base, > 0
};

/// sum of weight ((1 - alpha) v + alpha |v| min(deviation |grad H|, most_gain) t) over scales, with v = base (1 +
/// venturi |H|), H the height above the water blurred by sigma, alpha = min(1, |grad H|) in metres a metre, and t the
/// direction along the contour that v leans to.
///
/// Two departures. P3 adds deviation |grad H| as a speed of its own, the same in a gale and in still water: here it is
/// a multiple of |v|, bounded. And where v points straight up or down the slope, P3's direction jumps from one side to
/// the other: here the part along the contour falls to 0 within 12 degrees of that. (As printed, 1.52 makes deep water
/// faster, which the text calls Venturi's effect; a sill that speeds a current up would ask for the opposite.)
///
/// InvalidArgument by name for numbers out of range, "height" for cells that are none. m/s; linear time, parallel.
VectorField diverted_current(const HeightField& height_above_water, const DiversionOptions& options,
                             const RunContext& run);

}  // namespace seamount::geom

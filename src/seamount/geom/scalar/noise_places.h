// Noise at scattered places (noise.h).
#pragma once

#include <span>

#include "seamount/geom/scalar/noise.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {

/// out[i] = fbm(seed, shape, places[i].x, places[i].y), the same bits, without what that prepares for each place anew.
/// REQUIRES: equal sizes.
void fbm_places(Seed seed, const Fbm& shape, std::span<const Vec2> places, std::span<double> out);

}  // namespace seamount::geom

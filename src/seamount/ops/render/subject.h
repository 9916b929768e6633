// What a picture is about: the places of a terrain that a camera which is told nothing else keeps in view.
#pragma once

#include <vector>

#include "seamount/ops/render/ground.h"

namespace seamount::render {

/// In a sea: the largest land with its shallows, and what lies so near that it belongs to the picture; without land the
/// largest reef or shoal in the same way; without those, and inland, the whole terrain, down to `base` (metres). Metres
/// from the terrain's middle, on a raster of about 128 cells. Never empty. About a millisecond.
std::vector<Vec3> places_to_show(const Ground& ground, bool sea, float base);

/// All land with its shallows, or all reefs, or all, as above.
std::vector<Vec3> all_places_to_show(const Ground& ground, bool sea, float base);

}  // namespace seamount::render

// What grows on land, or does not: the natural style's material of a place above the water, from climate, slope, the
// water in its soil, and its place on ribs or in gullies.
//
// Water in the soil: the ratio of rain to what plants could use (Holdridge, "Determination of world plant formations",
// Science 105, 1947: 58.93 mm for every degree of the mean temperature), more in hollows, along valley floors and on
// shaded faces, less on ribs. From it and the warmth follow desert, steppe, grassland and forest, tundra and snow; the
// slope decides what holds: trees to about 40 degrees, grass to 45 (steeper where it is warm and wet), scree between 27
// and 38, rock beyond.
#pragma once

#include "seamount/ops/render/materials.h"

namespace seamount::render {

Material natural_land(const SurfacePoint& point, const Climate& climate);

/// Bare rock: jointed granite, dark basalt, pale limestone, sandstone in beds.
Rgb rock_colour(const SurfacePoint& point, Rock rock);

}  // namespace seamount::render

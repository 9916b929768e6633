// Colours of corals: alive, and bleached as they ail (P3 fig. 1.21).
#pragma once

#include "seamount/geom/things/makers.h"

namespace seamount::geom {

/// A live colour as health leaves it: white skeleton shows at 0.
inline Tone bleached(Tone live, double health) { return mix(tone(0xE4DED0), live, health); }

/// The live colour of a colony: around the main one, a little browner or yellower each.
inline Tone colony_tone(const ThingMaking& m, unsigned rgb, double spread = 0.12) {
  Rng rng(m.seed.derive("colour"));
  Tone live = m.main(rgb);
  const double light = 1.0 + spread * rng.uniform(-1.0, 1.0), warm = spread * rng.uniform(-1.0, 1.0);
  live = {live.r * light * (1.0 + warm), live.g * light, live.b * light * (1.0 - warm)};
  return bleached(live, m.health);
}

}  // namespace seamount::geom

// Colours of corals: alive, and bleached as they ail (P3 fig. 1.21).
#pragma once

#include <array>

#include "seamount/geom/things/makers.h"

namespace seamount::geom {

/// A live colour as health leaves it: white skeleton shows at 0.
inline Tone bleached(Tone live, double health) { return mix(tone(0xE4DED0), live, health); }

/// The live colour of a colony: around the main one, a little browner or yellower each; some are violet, green or rosy
/// by what lives in them, where no colour was asked for.
inline Tone colony_tone(const ThingMaking& m, unsigned rgb, double spread = 0.12) {
  Rng rng(m.seed.derive("colour"));
  Tone live = m.main(rgb);
  constexpr std::array<unsigned, 3> kOthers = {0x776C86, 0x6A7A5C, 0x94706A};
  const double lot = rng.uniform(), share = rng.uniform(0.4, 0.85);
  constexpr double kCommon = 0.5;
  if (m.own_colour && lot > kCommon)
    live = mix(live, tone(kOthers[static_cast<size_t>((lot - kCommon) / (1.0 - kCommon) * kOthers.size())]), share);
  const double light = 1.0 + spread * rng.uniform(-1.0, 1.0), warm = spread * rng.uniform(-1.0, 1.0);
  live = {live.r * light * (1.0 + warm), live.g * light, live.b * light * (1.0 - warm)};
  return bleached(live, m.health);
}

}  // namespace seamount::geom

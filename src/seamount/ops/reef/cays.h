// Cays: islets of sand that refracted waves pile up on the lee of reef flats.
//
// Flood, "Coral cays of the Capricorn and Bunker Groups", 1986: leeward ends of platforms, 1 to 3 m high; those over
// about 100 m wide keep fresh water and carry plants, smaller ones are bare banks that shift.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/model/grid.h"

namespace seamount::reef {

/// Share of cay_m in height above which a cay carries plants; bare banks stay below it.
inline constexpr double kPlants = 0.6;

struct CayRules {
  int count = 3;
  double swell_from_deg = 130.0;
  double radius_m = 100.0;  ///< of the reef's kernels
};

/// Up to `count` cays: 1 on the top of large ones, about 0.6 on that of bare banks, 0 outside; they lie on flats with
/// reef to windward (`distance` to the outline, positive inside; `lagoon` negative on flats; exposure and crowding as
/// of shape.h) and apart from each other. Only what the lattice resolves. Empty where there is none.
ScalarField make_cays(const CayRules& rules, const ScalarField& distance, const ScalarField& lagoon,
                      const ScalarField& exposure, const ScalarField& crowding, Seed seed);

}  // namespace seamount::reef

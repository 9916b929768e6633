// The summits of an island: where its land rises highest and how it falls from there to the foot of the mountains.
//
// A summit at c lifts the land at p to a share of its height that follows from x = |p - c| / (|p - c| + d), d the
// distance to the foot: eq. 1.1 of P0 in its distance form with the summit as outline 0, r / R on a circle. Several
// summits are joined by a power mean, so that saddles are round and no crease runs between them. Without drawn summits
// every lobe of the land (lobes.h) has one, as high as an island of its width would have, in proportion to the highest.
#pragma once

#include <optional>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/ops/island/shape.h"
#include "seamount/ops/island/summit_params.h"

namespace seamount::island {

/// A summit that stands.
struct Peak {
  Vec2 place;
  double radius_m = 0;  ///< of the land around it
  double height_m = 0;
  bool placed = false;  ///< by somebody
  bool exact = false;   ///< somebody asked for this height
  Curve profile = {};   ///< its own, or empty
};

/// The summits given, and one for every lobe in whose disc none was given; the highest first. `highest_m`: of the
/// highest lobe. Throws InvalidArgument{"summits[i].place"} for a place that is not on the land.
std::vector<Peak> choose_peaks(const Plan& plan, const std::vector<Summit>& given, std::optional<double> peak_m);

/// Lower peaks beside those of the large lobes, which nobody placed: none at massif 0, three each at 1. Highest first.
void add_side_peaks(double massif, Seed seed, std::vector<Peak>& peaks);

/// Where on [0, 1] a profile is highest: 0 at a summit, at the rim of a crater more. To a two-hundredth.
double highest_at(const geom::CurveFunction& profile);

/// How far land rises to its peaks, as v = 1 - x~ on a lattice: 1 on the highest, 0 on the foot of the mountains.
/// `distance`: from the foot, negative inside, on the lattice. `shape` maps x in [0, 1] to the share of the height over
/// `foot_m` that the island's profile has there and descends strictly from 1 to 0. `unevenness` in [0, 1]: how far
/// broad noise bends the slopes around a summit out of the round.
ScalarField rise(const std::vector<Peak>& peaks, const ScalarField& distance, const geom::CurveFunction& shape,
                 double foot_m, double unevenness, Seed seed, const RunContext& run);

}  // namespace seamount::island

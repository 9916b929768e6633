// Lagoons of wide reefs and the patch reefs in them, on the form's lattice (shape.h).
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::reef {

/// Metres from the inner edge of the flat into the lagoon behind it; negative on flats and outside. The flat is
/// `flat_width_m` wide to windward (exposure 1) and half of that in the lee, unevenly; what lies further from the
/// outline is lagoon, in pieces with a floor of at least least_m2: a reef that is hardly wider has no pools. Parallel.
ScalarField lagoon_depths(const ScalarField& distance, const ScalarField& exposure, double flat_width_m,
                          double least_m2, Seed seed, const RunContext& run);

/// Patch reefs on lagoon floors: share of the way from the floor to the flat, 0 between them. `per_km2` of them on the
/// mean, at random places, 15 to 160 m in radius with four times fewer of twice the size; only those that the lattice
/// resolves. They stand where `lagoon` is positive and where reefs are crowded (crowding over 0.45) around water.
/// Empty where there is none. Linear in their number and cells.
ScalarField scatter_knolls(const ScalarField& distance, const ScalarField& lagoon, const ScalarField& crowding,
                           double per_km2, Seed seed);

}  // namespace seamount::reef

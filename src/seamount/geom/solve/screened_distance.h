// The distance to cells as a material that spreads from them and decays would tell it (P3 eq. 1.39 to 1.41).
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// d = -L ln(c / C) where c is the steady state of D laplace(c) = mu c with c = C on the cells with inside != 0, no
/// flux over the grid's edge, and L = length_m = sqrt(D / mu) > 0. P3 climbs the gradient of c to the cell that it came
/// from; the logarithm gives the distance at once. It is smooth where the exact one (geom/polygon/distance.h, the
/// better choice otherwise) has creases, and differs from it: beside a straight border not at all for L of two cells or
/// more; at single cells it is larger by about L / 2 ln(r / cell), in hollows smaller. +infinity everywhere if the set
/// is empty, and further than 690 L from it. Gauss-Seidel sweeps in four orders, about (L / cell)^1.5 of them; one
/// thread.
ScalarField screened_distance(const Grid<uint8_t>& inside, double length_m, const RunContext& run);

}  // namespace seamount::geom

// The flow of very many Kelvinlets at once (P3 eq. 1.55).
#pragma once

#include <span>

#include "seamount/base/run_context.h"
#include "seamount/geom/scalar/kelvinlet.h"
#include "seamount/model/vector_field.h"

namespace seamount::geom {

/// Adds flow_of() of all Kelvinlets to a current, within 1 % of the strongest one's speed (where thousands push the
/// same way, within 0.05 % of what they make together). Kelvinlets reach infinitely far, so a smooth partition of unity
/// cuts each into rings: the innermost is added on a lattice that just resolves its radius, each further one on a
/// lattice twice as coarse, where all Kelvinlets of a node act as one; lattices are joined by cubic interpolation, so
/// that no ring shows. Kelvinlets may lie outside the grid.
///
/// InvalidArgument "kelvinlets" for a radius that is not above 0, a Poisson ratio outside [0, 0.5] or a number that is
/// none. Linear in Kelvinlets (about 1 us each) and in cells (times a logarithm); parallel, the same bits on any number
/// of threads.
void add_kelvinlets(std::span<const Kelvinlet> kelvinlets, VectorField& current, const RunContext& run);

/// The same cell by cell and one by one: exact, and the judge of the above.
void add_each_kelvinlet(std::span<const Kelvinlet> kelvinlets, VectorField& current, const RunContext& run);

}  // namespace seamount::geom

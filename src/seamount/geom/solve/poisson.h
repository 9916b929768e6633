// Smooth interpolation: the Laplace and Poisson equations on a grid with values fixed at chosen cells.
//
// Conjugate gradients with a multigrid cycle as preconditioner: aggregated coarse operators, so that fixed cells of any
// shape are known on every level, and Chebyshev-weighted Jacobi sweeps, which give the same bits on any number of
// threads (Tatebe 1993; Trottenberg, Oosterlee and Schueller 2001).
#pragma once

#include <cstdint>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

struct PoissonOptions {
  double tolerance = 1e-4;  ///< largest residual left, as a share of the largest with a zero interior
  int max_cycles = 30;      ///< steps at most
};

/// Replaces u where fixed == 0 by the solution of laplace(u) = 0 with u given where fixed != 0 and no flux through the
/// grid's edge. Cells cut off from every fixed cell become 0. Throws IncompatibleInputs unless the sizes agree.
/// Linear time, parallel; about eight more grids of memory.
void solve_laplace(ScalarField& u, const Grid<uint8_t>& fixed, const RunContext& run,
                   const PoissonOptions& options = {});

/// The same for laplace(u) = rhs, rhs in units of u per square metre.
void solve_poisson(ScalarField& u, const Grid<uint8_t>& fixed, const ScalarField& rhs, const RunContext& run,
                   const PoissonOptions& options = {});

}  // namespace seamount::geom

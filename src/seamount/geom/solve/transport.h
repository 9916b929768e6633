// Materials that flow, spread, decay and settle: advection, reaction and diffusion on a grid (P3 eq. 1.35 to 1.38).
//
//   dc/dt + div(flow c) = diffusivity laplace(c) - decay c + source,   c >= 0
//
// P3 prints the advective form flow . grad(c), which makes and destroys material wherever the flow converges or parts;
// in the conservative form used here what is deposited is what decays, leaves over the border or is taken. Finite
// volumes: the flow through a face is the mean of its two cells' flow, and carries the upwind cell's concentration, so
// that the matrix is an M-matrix and no concentration can fall below 0. Upwinding smears as a diffusivity of
// |flow| cell / 2 would.
//
// Sources may be negative: they take what they can, and no more than there is (an obstacle problem).
//
// Borders are open. Beyond them lies a ring of cells that hold nothing, or what `around` says: material leaves with the
// flow and by diffusion into that ring, and comes in from it. Zero-gradient walls would blow up (P3 fig. 1.29).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/vector_field.h"

namespace seamount::geom {

/// One material and how it moves. Concentrations are in any unit u per cell area, sources in u/s.
struct Transport {
  const ScalarField* source = nullptr;  ///< deposition (> 0) or absorption (< 0) a second; REQUIRED
  const VectorField* flow = nullptr;    ///< m/s; null: still water
  const ScalarField* around = nullptr;  ///< its border cells are the concentrations beyond the border; null: 0
  double diffusivity_m2_s = 0.0;        ///< >= 0
  double decay_per_s = 0.0;             ///< >= 0
};

struct SteadyOptions {
  double tolerance = 3e-4;  ///< error left, as a share of the largest concentration; an estimate, > 0
  int max_cycles = 60;      ///< of the finest level; what is not reached by then is said through run.note
};

/// The concentrations at which nothing changes any more. Full multigrid: each level starts from the coarser one's
/// solution, Gauss-Seidel sweeps in all four corner orders follow the flow, corrections come from agglomerated finite
/// volumes whose shape is that of the solution itself where material gathers in narrow places. The start is always the
/// same, so the result depends on nothing but its inputs: the same bits on any number of threads.
///
/// A source of zeros gives zeros. Without decay and diffusion, material that cannot reach the border has no steady
/// state: InvalidArgument "decay_per_s". InvalidArgument for negative or infinite numbers, IncompatibleInputs unless
/// all sizes agree. Linear time, one thread: about 20 ms for 512 x 512 cells, more where weak decay meets closed
/// eddies; 60 bytes a cell.
ScalarField steady_state(const Transport& transport, const RunContext& run, const SteadyOptions& options = {});

/// The same for several materials side by side, each on one thread. As steady_state of each, bit for bit.
std::vector<ScalarField> steady_states(std::span<const Transport> transports, const RunContext& run,
                                       const SteadyOptions& options = {});

struct EulerOptions {
  double tolerance = 1e-7;        ///< stops when no cell changes more a step, as a share of the largest concentration
  int64_t max_steps = 1'000'000;  ///< what is not reached by then is said through run.note
};

/// The same by explicit Euler steps from nothing (P3 algorithm 2, in double precision): the plain judge of
/// steady_state, with the same discretisation. The step is 0.9 of the largest that keeps concentrations from turning
/// negative, at most min(cell^2 / (4 diffusivity), cell / (2 |flow|)). Thousands of steps; parallel.
ScalarField euler_state(const Transport& transport, const RunContext& run, const EulerOptions& options = {});

/// What comes and goes in a state, in u/s over the whole grid.
struct MaterialBalance {
  double deposited = 0.0;  ///< by sources above 0
  double taken = 0.0;      ///< by sources below 0: what they ask for where there is material, what arrives elsewhere
  double decayed = 0.0;
  double left = 0.0;     ///< over the border, with the flow and by diffusion
  double entered = 0.0;  ///< over the border, from `around`

  /// 0 in a steady state: what accumulates.
  double change() const { return deposited + entered - taken - decayed - left; }
};

MaterialBalance material_balance(const ScalarField& concentration, const Transport& transport);

}  // namespace seamount::geom

// What objects deposit and absorb, as sources of the materials' transport (P3 eq. 1.35).
#pragma once

#include <vector>

#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

/// S of each material in concentration per second: the sum over the objects that are seen from a window of (deposition
/// - absorption) exp(-d^2 / (2 radius^2)), d the distance to the skeleton, 0 within regions. A falloff that is narrower
/// than the cells can show is spread over about a cell with the same total. An empty field where nothing is deposited.
/// Parallel over materials; linear in the cells that objects reach, four radii.
std::vector<ScalarField> material_sources(const Scene& scene, const Rules& rules, const GridFrame& frame, int window,
                                          const RunContext& run);

}  // namespace seamount::ecosystem

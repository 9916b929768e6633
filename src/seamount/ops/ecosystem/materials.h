// The materials of a scene at rest: what is deposited has gone where slopes, currents and diffusion take it (P3 eq.
// 1.35-1.38).
#pragma once

#include <vector>

#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

/// Steady states of all materials, one after another where one turns into the next, else side by side. `around`: the
/// materials to continue at the border, on the environment's frame; empty: open sea. Reads the environment's frame,
/// height and current.
std::vector<ScalarField> materials_at_rest(const Scene& scene, const Rules& rules, const Environment& environment,
                                           int window, const std::vector<ScalarField>& around, const RunContext& run);

/// Velocity that carries a material: -density grad H + flow_coupling W (eq. 1.36; printed with the wrong sign of
/// gravity).
VectorField carrying_flow(const Material& material, const Environment& environment, const RunContext& run);

}  // namespace seamount::ecosystem

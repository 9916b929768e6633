// The materials of a scene at rest: what is deposited has gone where slopes, currents and diffusion take it (P3 eq.
// 1.35-1.38).
#pragma once

#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

/// Fills in the materials of an environment, which reads its frame, height, current and what is around it (nothing:
/// open sea): steady states of all, one after another where one turns into the next, else side by side. `before`: an
/// environment with the same height, current and surroundings, or one without materials: what comes from the same
/// sources is taken from it.
void bring_to_rest(const Scene& scene, const Rules& rules, int window, Environment& before, Environment& environment,
                   const RunContext& run);

/// Velocity that carries a material: -density grad H + flow_coupling W (eq. 1.36; printed with the wrong sign of
/// gravity).
VectorField carrying_flow(const Material& material, const Environment& environment, const RunContext& run);

}  // namespace seamount::ecosystem

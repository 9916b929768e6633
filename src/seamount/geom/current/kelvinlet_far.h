// The far field of many Kelvinlets: smooth, so that a lattice holds it, and a convolution of their strengths.
#pragma once

#include <span>

#include "seamount/base/run_context.h"
#include "seamount/geom/current/flow_lattice.h"
#include "seamount/geom/current/kelvinlet_rows.h"

namespace seamount::geom::kelvinlets {

/// Adds what sources do beyond their near field, (1 - near_share) times their flow, by particles on a mesh (Hockney
/// and Eastwood 1988): strengths are spread over mesh nodes about two lattice steps apart so that quintic polynomials
/// see no difference, convolved by Fourier transforms, and read back the same way. The radius is taken as the sources'
/// mean, which matters beyond half the reach only. REQUIRES: sources within half the lattice's width of it.
void add_far(std::span<const Source> sources, double reach_m, FlowLattice& lattice, const RunContext& run);

}  // namespace seamount::geom::kelvinlets

// Harmonic interpolation over a graph: values are known at some nodes, every other node is about the mean of its
// neighbours. The counterpart of poisson.h for networks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"

namespace seamount::geom {

/// Replaces value[i] where fixed[i] == 0 by nearly the solution of the graph's Laplace equation: conjugate gradients
/// over ever finer groups of nodes (cascadic multigrid, Bornemann and Deuflhard 1996; groups are runs of four nodes in
/// their order, so that order should be spatial), to within about 2 % of the fixed values' range. Stays in that range
/// and has no creases. Parts of the graph without fixed nodes keep their values. `starts` (nodes + 1 of them) into
/// `neighbours`, symmetric. REQUIRES: equal sizes, finite values. Serial, linear: about 1 us per node.
void solve_graph_laplace(std::span<const uint32_t> starts, std::span<const int32_t> neighbours,
                         std::span<const uint8_t> fixed, std::span<double> value, const RunContext& run);

}  // namespace seamount::geom

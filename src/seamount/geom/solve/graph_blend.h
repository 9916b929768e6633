// Smooth interpolation over a graph: values known at some nodes, in between as smooth as a stretched skin.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"

namespace seamount::geom {

/// Replaces value[i] where fixed[i] == 0 by about the mean of its neighbours (the graph's Laplace equation), by
/// conjugate gradients over ever finer groups of nodes (cascadic multigrid, Bornemann and Deuflhard 1996; groups are
/// runs of four nodes in their order, so that order should be spatial). Lies within the fixed values' range, keeps
/// them, and has no creases; about 2 % of their range from the solution. Parts of the graph without fixed nodes keep
/// their values. `starts` (nodes + 1 of them) into `neighbours`, symmetric. REQUIRES: equal sizes, finite values.
/// Serial, linear: about 1 us per node.
void blend_over_graph(std::span<const uint32_t> starts, std::span<const int32_t> neighbours,
                      std::span<const uint8_t> fixed, std::span<double> value, const RunContext& run);

}  // namespace seamount::geom

// Growth proper: in which order the nodes of a network rise out of the sea.
//
// Source: P2 sec. 4.1, 4.2 (inward Open Eden Growth, Algorithm 1), 4.5 (two fronts, special cases, the last pass). What
// the text leaves open, decided here:
//  - Both fronts start on the region's own border nodes, in random order; n- and n+ count from 1.
//  - A node grows next to a frontier node drawn in proportion to P, at one of its free neighbours, all alike; the
//    descending front draws in proportion to 1 - P. P is clamped to [0.001, 0.999].
//  - Regions are a tree: a basin's outline is its upper border, a basin inside a region belongs to its lower border.
//  - Where the heights of a region's outline and of those in it are known, the fronts start at those heights' shares of
//    its range instead of 0 and 1, so that a low hill in a high region does not draw the ground around it up; between
//    outlines of different height the shares blend.
//  - Land whose outline lies nowhere in the network starts where rivers leave it, else at the network's edge. A part of
//    a region that no lower ground touches drains over that edge if it reaches it, else (in a basin) to its own lowest
//    node.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/growth/region_graph.h"
#include "seamount/ops/contour/growth/river_nodes.h"

namespace seamount::contour {

/// Most nodes: all ranks of a region are different floats.
inline constexpr int64_t kMostNodes = 16'000'000;

/// Ranks in (0, 1), all different within a region, 0 outside (model/tin.h). Each node has a neighbour of lower rank in
/// its region or one on a lower side of its border (border_of), but for those where a part without lower ground drains.
/// REQUIRES: as make_region_graph, one probability per node, finite, at most kMostNodes nodes. Regions grow
/// side by side, one on one thread; n log n, about 0.2 us and 90 bytes per node.
std::vector<float> grow_ranks(std::span<const std::array<int32_t, 3>> triangles, std::span<const int32_t> region,
                              const std::vector<TinRegion>& regions, std::span<const float> probability,
                              const RiverNodes& rivers, Seed seed, const RunContext& run);

/// One Open Eden Growth over the graph from `seeds`, which come first and in their order. step[i] = 1, 2, ... in the
/// order in which nodes are reached; nodes whose step is not 0 at first are not entered. weights: in
/// [1, WeightedSampler::kMost] per node; `against` draws in proportion to kMost - weight instead.
void eden_growth(const RegionGraph& graph, std::span<const int32_t> seeds, std::span<const uint32_t> weights,
                 bool against, Rng rng, std::span<uint32_t> step, const RunContext& run);

/// P as an integer weight, clamped to [0.001, 0.999].
uint32_t growth_weight(double probability);

}  // namespace seamount::contour

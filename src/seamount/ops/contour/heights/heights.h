// contour.heights: heights for a grown network, from a distribution of heights and the heights of its outlines.
//
// Source: P2 sec. 3.3, 4.4, fig. 8 and 23. Growth gives an order; heights are the distribution's quantiles in that
// order, so that another distribution needs no other growth. Where we depart or the paper is silent:
//  - An outline whose height its author gave is a contour of that height: nodes just inside are not lower, nodes just
//    outside not higher. Ground between two such outlines takes the part of the distribution between their heights.
//    Outlines without height lie where the distribution puts them; all regions of one depth between the same outlines
//    with height rise together, as in the paper.
//  - Nodes beside an outline are put in the order of their distance to it, so that the contour follows the outline
//    itself and not the unevenness of the nodes (`outlines: follow`).
//  - Of several summits the one on the wider ground is the highest (P2 sec. 6.1), in proportion to the ground's width.
//  - Places that growth leaves to the very end would be towers, however narrow: ground steeper than twice the usual
//    slope is cut back (`spikes: cut`), except in regions whose peak is given. About a hundredth of the ground moves.
//  - Outside the regions the ground falls from the nearest outline to the network's edge, a sea floor where that is at
//    0 (sea_floor.cpp).
//  - Basins fall from their outline by basin_depth_m.
// Each node but a basin's deepest and those at the network's edge has a lower neighbour, as far as the growth gave it
// one.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/heights/heights_params.h"

namespace seamount::contour {

/// The network with heights; everything else stays. `terrain`, if there, gives the distribution. Throws
/// InvalidArgument for a distribution of no ground, min_m not below max_m, an outline's height outside the range;
/// IncompatibleInputs for a network that was not grown. n log n, about 1 us and 100 bytes per node; serial but for the
/// distances to outlines.
Tin heights(Tin tin, const HeightField* terrain, const HeightsParams& params, const RunContext& run);

}  // namespace seamount::contour

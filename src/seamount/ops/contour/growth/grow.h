// contour.grow: from regions to a network whose nodes know in which order they rise.
//
// Source: P2 sec. 4.2, 4.3 (Poisson discs over the region widened by 4 r, Delaunay triangulation), 4.5 (several
// regions). Growth itself is in growth.h, the tree of regions in regions.h. Departures: the least distance of nodes,
// 2 r, is the parameter; sampling is maximal, so that a count of particles is met within a few per cent by
// spacing = 0.835 sqrt(area / count) where the authors' looser discs have 0.763; ground at the domain's edge goes on
// beyond it for two spacings, so that it has no coast there.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/growth/grow_params.h"
#include "seamount/ops/contour/growth/regions.h"

namespace seamount::contour {

/// The network of the domain and a little beyond its edge, ever coarser away from the regions; rank per node, no
/// heights. `probability`: in [0, 1] wherever nodes lie, read bilinearly,
/// over any frame (clamped at its edge); null: params.probability. `rivers`: laid into the network (rivers.h), besides
/// params.rivers. Throws InvalidArgument for params out of range, more than kMostNodes nodes (with the estimate of
/// memory and the spacing that would do), a region into which no node falls at params.spacing_m (with the one that
/// would do), what prepare_rivers throws, IncompatibleInputs for probabilities that are not numbers in [0, 1]. Where
/// `particles` are too few for the smallest regions, more are chosen, up to half a million, and what is still smaller
/// is left out; both is said. Growth of one region is serial, the rest parallel; about 1.5 us and 200 bytes per node.
Tin grow(RegionTree tree, const GridFrame& domain, const ScalarField* probability, std::vector<RiverLine> rivers,
         GrowParams params, Seed seed, const RunContext& run);

// The parts of grow(), for networks whose regions nobody drew (refine.h). Params are not checked.

/// Nodes, triangles, beds and the region of each node; regions may be without nodes.
Tin scatter_nodes(const RegionTree& tree, const GridFrame& domain, std::vector<RiverLine> rivers,
                  const GrowParams& params, Seed seed, const RunContext& run);
/// Sea that the network shuts off becomes land, which is said (fit_regions.h).
void close_waters(Tin& tin, const RunContext& run);
/// Ranks for the nodes.
void grow_nodes(Tin& tin, const ScalarField* probability, const GrowParams& params, Seed seed, const RunContext& run);

/// Throws InvalidArgument{"spacing_m"} for more than kMostNodes nodes.
void check_spacing(const RegionTree& tree, const GridFrame& domain, double spacing_m);

/// Spacing that gives params.particles or is given. Metres. REQUIRES: a region in the domain.
double node_spacing(const RegionTree& tree, const GridFrame& domain, const GrowParams& params);

/// An outline of its own making, for when nobody drew one: a coast about the domain's middle.
RegionTree random_region(const GridFrame& domain, Seed seed);

}  // namespace seamount::contour

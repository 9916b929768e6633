// Nodes of the sea: the ground outside all regions, out to the domain's edge.
//
// P2 sec. 4.2 samples a region and a rim of 4 r around it, beyond which nothing is known: a raster of such a network
// has an island in a flat sea. Ours covers the whole domain. Near the land nodes lie as densely as on it, further out
// ever less so, since what lies there is smooth: about eight rows of nodes' worth, however wide the sea.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/poisson_disc.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/growth/regions.h"

namespace seamount::contour {

/// Spacings around the regions in which nodes lie as densely as in them.
inline constexpr double kDenseSea = 3.0;

/// Nodes of the sea, in rows along the coast: for estimates.
inline constexpr double kSeaRows = 8.0;

/// Appends nodes to a sampling of the regions and kDenseSea spacings around them: their distance doubles whenever the
/// distance from the land has doubled and a bit, up to a 40th of the domain. Moves the lattice's origin. Returns the
/// spacing of each appended node over the sampling's: a power of two. Of a sea too wide for the lattice what is too far
/// away stays empty. REQUIRES: regions in the domain. Serial; about 1 us per node of the sea and a few ms.
std::vector<int32_t> add_sea_nodes(const RegionTree& tree, const GridFrame& domain, double spacing_m, Seed seed,
                                   geom::DiscSampling& discs, const RunContext& run);

/// Takes out the long triangles beyond the domain's edge that only close hollows in the network's border. `wide`: of
/// the network's last nodes, as add_sea_nodes() returned it. Linear.
void drop_slivers(Tin& tin, const std::vector<int32_t>& wide, double spacing_m);

}  // namespace seamount::contour

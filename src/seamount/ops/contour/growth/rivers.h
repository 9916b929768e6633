// Rivers that growth respects: courses with a bed that falls all the way, ready to be laid into a network.
//
// Source: P2 sec. 6.6 names them as future work: a hand-drawn river network with bed elevations. Ours: river nodes take
// their place on the course itself and their height from the bed; the ascending front starts on them as it does on the
// coast, so that the land rises from the river on both sides and contours bend upstream along it (growth.h); between
// rivers and coasts heights stand on a base level that runs from bed to bed (contour.heights).
#pragma once

#include <string>
#include <vector>

#include "seamount/geom/polygon/poisson_disc.h"
#include "seamount/model/areas.h"
#include "seamount/model/drawn.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/growth/regions.h"
#include "seamount/ops/contour/growth/river_nodes.h"

namespace seamount::contour {

/// From source to mouth, at points at most a step apart.
struct River {
  Polyline points;
  std::vector<double> bed_m;   ///< falls strictly
  std::vector<double> half_m;  ///< half the width of the flat valley floor
};

/// Courses as smooth lines through their points. Beds: given at every point; or at source and mouth, or only at the
/// mouth, or not at all: then the bed falls as rivers do, steep at the source and ever gentler (as the square of the
/// way from the mouth), by 3 m in 100 m on average, down to the river that it joins, else to the outermost outline
/// there (0 if that has no height). A river whose mouth lies near another one (within two steps or a tenth of its
/// length) joins it there and falls to it; one that ends near the shore is led to it. Rivers come after those that they
/// join. Throws InvalidArgument{field} in one line with the river and a place: fewer than two points, places or beds
/// that are not finite, another number of beds, a bed that rises on its way, a tributary that ends below the river it
/// joins, a river wholly outside the regions or that ends on dry land, a circle of tributaries. Linear in points times
/// rivers.
std::vector<River> prepare_rivers(const std::vector<RiverLine>& lines, const RegionTree& tree, const GridFrame& domain,
                                  double step_m, const std::string& field);

/// Step of the nodes on a course, in spacings.
inline constexpr double kRiverStep = 0.7;

/// Lays rivers into a sampling: nodes nearer than 0.6 spacings make room for nodes on the courses, a step apart, whose
/// sides are then sure to be sides of the triangulation. Returns the bed at every point of the new sampling, kNoBed off
/// the rivers: of the course, and of the valley floor along it, which rises by 1 m in 1000 m from the course.
std::vector<float> lay_rivers(const std::vector<River>& rivers, const RegionTree& tree, const GridFrame& domain,
                              double spacing_m, geom::DiscSampling& discs);

/// Takes the beds outside the regions and in basins off a network; the nodes that keep theirs.
RiverNodes keep_river_nodes(Tin& tin);

/// The lines of a drawing, from source to mouth, with what their numbers say: "source_m" and "mouth_m" (bed),
/// "source_width_m" and "mouth_width_m", or "width_m" for both. Reaches with "fall_m", as hydrology.rivers makes them,
/// add their falls up from the mouth.
std::vector<RiverLine> river_lines(const Drawing& drawing);

}  // namespace seamount::contour

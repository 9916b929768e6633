// The parts of contour.heights (heights.h) that work on nodes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/tin/node_graph.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/heights/distribution.h"
#include "seamount/ops/contour/heights/height_bands.h"

namespace seamount::contour {

/// A node beside another region's.
struct Shore {
  int32_t node = 0;
  int32_t outline = 0;  ///< the region whose outline lies between: the node's own, or one directly inside its region
  bool inside = false;  ///< of that outline
};

/// Every node beside an outline, once per outline, by outline; nodes outside all regions as well.
std::vector<Shore> find_shores(const Tin& tin, const geom::NodeGraph& graph, const RunContext& run);

/// Between which heights outlines and rivers let a node lie. Where the floor is above the cap, the floor counts.
struct Limits {
  std::vector<double> floor, cap;
};
Limits find_limits(const Tin& tin, const std::vector<RegionBand>& bands, const std::vector<Shore>& shores);

/// River nodes lie at their beds, the land beside them not lower.
void limit_rivers(const Tin& tin, const geom::NodeGraph& graph, Limits& limits);

/// Quantiles in the order of ranks: per group and level, or per region where outlines inside it have heights of their
/// own. Nodes outside stay 0.
std::vector<double> band_heights(const Tin& tin, const std::vector<RegionBand>& bands, const std::vector<Shore>& shores,
                                 const HeightDistribution& distribution, const HeightsParams& params,
                                 const RunContext& run);

/// In regions with rivers, lets heights start from the bed that the water of a node comes to, smoothed across divides,
/// instead of from the region's lowest height: a node keeps its share of the way from there to the top.
void stand_on_rivers(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                     std::vector<double>& height, const RunContext& run);

/// In networks with rivers, lifts hollows between what stands on different beds to where their water leaves: cut down
/// to the beds instead, they would be trenches across the divides. Not over a node's cap. n log n.
void fill_behind_rivers(const Tin& tin, const geom::NodeGraph& graph, const Limits& limits, std::vector<double>& height,
                        const RunContext& run);

/// Lays nodes beside outlines at the heights that a plane through the outline has there, as steep as the ground is, so
/// that the contour passes between them where the outline does. Sets nodes outside the regions too. `beside`: distance
/// from the outline of the nodes that were laid, of others -1 as before.
void follow_outlines(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                     const std::vector<Shore>& shores, std::vector<double>& height, std::vector<float>& beside,
                     const RunContext& run);

/// Lowers what is steeper than twice the root of the mean square slope above the lower ground around it, down to the
/// node's floor at most; nodes of regions with a peak stay. A node that is lowered keeps a lower neighbour.
void cut_spikes(const Tin& tin, const geom::NodeGraph& graph, const Limits& limits, std::vector<double>& height,
                const RunContext& run);

/// Nodes of the regions, drains before what they drain: by level, then rank.
std::vector<int32_t> rank_order(const Tin& tin, const std::vector<RegionBand>& bands, const RunContext& run);

/// The lowest neighbour of lower rank or in lower ground; -1: an outlet, or the deepest node of a basin.
std::vector<int32_t> find_drains(const Tin& tin, const geom::NodeGraph& graph, const std::vector<double>& height,
                                 const RunContext& run);

/// Of nodes without a lower neighbour, lowers those that dam the water on its way down the ranks, then lifts nodes that
/// still have none above the one that they drain to, and rounds to floats that differ. Outside nodes
/// and those at the network's edge count as outlets.
std::vector<float> drain(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                         const Limits& limits, std::vector<double> height, const RunContext& run);

/// Lifts nodes without a lower neighbour, and those that have none because of it, to the height at which their water
/// leaves: this happens between hills that are too near each other for nodes in the valley. Nodes outside the regions,
/// in basins and at the network's edge stay. n log n if there are such nodes.
void fill_pits(Tin& tin, const geom::NodeGraph& graph, const RunContext& run);

/// 1 for each node around which triangles do not close.
std::vector<uint8_t> edge_nodes(const Tin& tin, const geom::NodeGraph& graph);

/// Heights of nodes outside the regions: a sea floor that begins as steep as follow_outlines() laid it, goes on at
/// `slope` (m/m) and falls all the way to the network's edge, where each node but those at the edge has a lower
/// neighbour. `beside`: of nodes laid by follow_outlines(), else -1. `width_m`: of the land. n log n in nodes outside.
void fall_outside(const Tin& tin, const geom::NodeGraph& graph, const std::vector<RegionBand>& bands,
                  const std::vector<Shore>& shores, const std::vector<float>& beside, double slope, double width_m,
                  std::vector<double>& height, const RunContext& run);

}  // namespace seamount::contour

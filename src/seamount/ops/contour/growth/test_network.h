// What tests ask of grown networks with heights.
#pragma once

#include <algorithm>

#include "seamount/geom/tin/node_graph.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

inline size_t at(int32_t i) { return static_cast<size_t>(i); }

/// Nodes in regions that are no basins, without lower neighbour, in the domain.
inline int endorheic(const Tin& tin) {
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size());
  int count = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    const Vec2 p = tin.nodes[i];
    const GridFrame& f = tin.frame;
    if (p.x < f.west_m || p.x > f.east_m() || p.y < f.south_m() || p.y > f.north_m) continue;
    if (tin.region[i] < 0 || tin.regions[at(tin.region[i])].basin) continue;
    const auto around = graph.around(i);
    count +=
        std::none_of(around.begin(), around.end(), [&](int32_t n) { return tin.height_m[at(n)] < tin.height_m[i]; });
  }
  return count;
}

/// Is region r the one inside `outline`, or in it?
inline bool within(const Tin& tin, int32_t r, int32_t outline) {
  while (r >= 0 && r != outline) r = tin.regions[at(r)].parent;
  return r == outline;
}

/// Nodes on the wrong side of an outline's height, by more than a millimetre, among those beside it. Nodes of hills and
/// basins beside it may lie at any height that its own outline does not ask for.
inline int dishonoured(const Tin& tin) {
  int count = 0;
  for (const auto& t : tin.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const size_t a = at(t[k]);
      const size_t b = at(t[(k + 1) % 3]);
      for (size_t r = 0; r < tin.regions.size(); ++r) {
        const TinRegion& region = tin.regions[r];
        const auto outline = static_cast<int32_t>(r);
        if (!region.height_m || within(tin, tin.region[a], outline) == within(tin, tin.region[b], outline)) continue;
        const bool a_in = within(tin, tin.region[a], outline);
        const auto in = static_cast<double>(tin.height_m[a_in ? a : b]);
        const auto out = static_cast<double>(tin.height_m[a_in ? b : a]);
        const int32_t around = tin.region[a_in ? b : a];
        if (around >= 0 && !within(tin, outline, around)) continue;
        const double h = *region.height_m;
        constexpr double kSlack = 1e-3;
        count += region.basin ? (in > h + kSlack || out < h - kSlack) : (in < h - kSlack || out > h + kSlack);
      }
    }
  }
  return count;
}

}  // namespace seamount::contour

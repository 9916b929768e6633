#include "seamount/ops/contour/refine/refine_regions.h"

#include <algorithm>

#include "seamount/base/error.h"
#include "seamount/geom/tin/node_graph.h"
#include "seamount/ops/contour/growth/fit_regions.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// Held contours pass a river where its bed says, not a little above or below: river nodes go over to the region around
/// theirs where they lie lower than its outline, and to one beside them where they lie higher than its outline.
void fit_rivers(Tin& tin, const geom::NodeGraph& graph) {
  if (tin.bed_m.empty()) return;
  const auto outline = [&](int32_t r) { return *tin.regions[at(r)].height_m; };
  for (bool moved = true; moved;) {
    moved = false;
    for (size_t node = 0; node < tin.nodes.size(); ++node) {
      int32_t& here = tin.region[node];
      if (tin.bed_m[node] == Tin::kNoBed || here < 0 || tin.regions[at(here)].basin) continue;
      const auto bed = static_cast<double>(tin.bed_m[node]);
      while (bed < outline(here) && tin.regions[at(here)].parent >= 0 && !tin.regions[at(here)].basin) {
        here = tin.regions[at(here)].parent;
        moved = true;
      }
      for (const int32_t neighbour : graph.around(node)) {
        const int32_t there = tin.region[at(neighbour)];
        if (there < 0 || tin.regions[at(there)].parent != here || tin.regions[at(there)].basin) continue;
        if (bed <= outline(there)) continue;
        here = there;
        moved = true;
      }
    }
  }
}

}  // namespace

void fit_regions(Tin& tin, const RunContext& run) {
  fit_rivers(tin, geom::make_node_graph(tin.triangles, tin.nodes.size(), run));
  run.check_cancelled();
  join_strays(tin, run);
  drop_empty_regions(tin);
  if (tin.regions.empty()) throw InvalidArgument("tin", "no node falls into its land");
}

}  // namespace seamount::contour

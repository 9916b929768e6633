#include "seamount/ops/contour/refine/refine_regions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/geom/tin/node_graph.h"
#include "seamount/geom/tin/tin_border.h"

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

/// Is `inner` the region `outer` or in it? Never for nodes outside.
bool lies_in(const Tin& tin, int32_t inner, int32_t outer) {
  while (inner >= 0 && inner != outer) inner = tin.regions[at(inner)].parent;
  return inner >= 0;
}

/// A part of a region that hangs together, and how water leaves it.
struct Part {
  std::vector<int32_t> nodes;
  bool drains = false;
  int32_t beside = -1;  ///< the least region that it touches
};

Part part_from(const Tin& tin, const geom::NodeGraph& graph, const std::vector<char>& rim, int32_t first,
               std::vector<char>& seen, const RunContext& run) {
  const int32_t here = tin.region[at(first)];
  Part part{{first}, false, -1};
  seen[at(first)] = 1;
  for (size_t i = 0; i < part.nodes.size(); ++i) {
    if (i % 16384 == 0) run.check_cancelled();
    const int32_t node = part.nodes[i];
    part.drains = part.drains || rim[at(node)] != 0;
    for (const int32_t neighbour : graph.around(at(node))) {
      const int32_t there = tin.region[at(neighbour)];
      if (there == here) {
        if (seen[at(neighbour)] == 0) part.nodes.push_back(neighbour);
        seen[at(neighbour)] = 1;
        continue;
      }
      const bool beside = there >= 0 && tin.regions[at(there)].parent == tin.regions[at(here)].parent;
      const bool inside = lies_in(tin, there, here);
      part.drains = part.drains || (inside ? tin.regions[at(there)].basin : !beside);
      if (inside || beside) part.beside = part.beside < 0 ? there : std::min(part.beside, there);
    }
  }
  return part;
}

/// Whether any part of a hill's region was given away.
bool join_strays(Tin& tin, const geom::NodeGraph& graph, const std::vector<char>& rim, const RunContext& run) {
  std::vector<char> seen(tin.nodes.size(), 0);
  bool any = false;
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    const int32_t here = tin.region[node];
    if (here < 0 || seen[node] != 0 || tin.regions[at(here)].basin) continue;
    const Part part = part_from(tin, graph, rim, static_cast<int32_t>(node), seen, run);
    if (part.drains || part.beside < 0) continue;
    for (const int32_t stray : part.nodes) tin.region[at(stray)] = part.beside;
    any = true;
  }
  return any;
}

/// Takes out regions without nodes; what they enclosed belongs to what encloses them.
void drop_empty_regions(Tin& tin) {
  std::vector<char> full(tin.regions.size(), 0);
  for (const int32_t r : tin.region) {
    if (r >= 0) full[at(r)] = 1;
  }
  std::vector<int32_t> place(tin.regions.size(), -1);  // itself, or the nearest one around it that stays
  std::vector<TinRegion> kept;
  for (size_t i = 0; i < tin.regions.size(); ++i) {
    TinRegion& region = tin.regions[i];
    const int32_t around = region.parent < 0 ? -1 : place[at(region.parent)];
    if (full[i] == 0) {
      place[i] = around;
      continue;
    }
    region.parent = around;
    place[i] = static_cast<int32_t>(kept.size());
    kept.push_back(std::move(region));
  }
  if (kept.empty()) throw InvalidArgument("tin", "no node falls into its land");
  tin.regions = std::move(kept);
  for (int32_t& r : tin.region) r = r < 0 ? r : place[at(r)];
}

std::vector<char> border_of_network(const Tin& tin, const RunContext& run) {
  std::vector<char> rim(tin.nodes.size(), 0);
  for (const std::vector<int32_t>& ring : geom::border_rings(tin, run)) {
    for (const int32_t node : ring) rim[at(node)] = 1;
  }
  return rim;
}

bool has_lower(const Tin& tin, const geom::NodeGraph& graph, size_t node) {
  const auto around = graph.around(node);
  return std::any_of(around.begin(), around.end(), [&](int32_t n) { return tin.height_m[at(n)] < tin.height_m[node]; });
}

}  // namespace

void fit_regions(Tin& tin, const RunContext& run) {
  constexpr int kRounds = 20;  // each gives parts to regions further in
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size(), run);
  const std::vector<char> rim = border_of_network(tin, run);
  fit_rivers(tin, graph);
  run.check_cancelled();
  for (int round = 0; round < kRounds && join_strays(tin, graph, rim, run); ++round) {
  }
  drop_empty_regions(tin);
}

void fill_pits(Tin& tin, const RunContext& run) {
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size(), run);
  std::vector<char> done = border_of_network(tin, run);
  bool any = false;
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (node % 16384 == 0) run.check_cancelled();
    const int32_t r = tin.region[node];
    if (r < 0 || tin.regions[at(r)].basin) done[node] = 1;
    any = any || (done[node] == 0 && !has_lower(tin, graph, node));
  }
  if (!any) return;
  using Place = std::pair<float, int32_t>;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> front;
  for (size_t node = 0; node < done.size(); ++node) {
    if (node % 16384 == 0) run.check_cancelled();
    if (done[node] != 0) front.emplace(tin.height_m[node], static_cast<int32_t>(node));
  }
  for (size_t taken = 1; !front.empty(); ++taken) {
    if (taken % 16384 == 0) run.check_cancelled();
    const auto [height, node] = front.top();
    front.pop();
    for (const int32_t neighbour : graph.around(at(node))) {
      if (done[at(neighbour)] != 0) continue;
      done[at(neighbour)] = 1;
      float& z = tin.height_m[at(neighbour)];
      z = std::max(z, std::nextafter(height, std::numeric_limits<float>::max()));
      front.emplace(z, neighbour);
    }
  }
}

}  // namespace seamount::contour

#include "seamount/ops/contour/growth/fit_regions.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "seamount/geom/tin/node_graph.h"
#include "seamount/geom/tin/tin_border.h"

namespace seamount::contour {
namespace {

size_t at(int32_t i) { return static_cast<size_t>(i); }

bool is_beyond(const GridFrame& f, Vec2 p) {
  return p.x < f.west_m || p.x > f.east_m() || p.y < f.south_m() || p.y > f.north_m;
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
bool join_once(Tin& tin, const geom::NodeGraph& graph, const std::vector<char>& rim, const RunContext& run) {
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

std::vector<char> border_of_network(const Tin& tin, const RunContext& run) {
  std::vector<char> rim(tin.nodes.size(), 0);
  for (const std::vector<int32_t>& ring : geom::border_rings(tin, run)) {
    for (const int32_t node : ring) rim[at(node)] = 1;
  }
  return rim;
}

}  // namespace

int64_t close_shut_waters(Tin& tin) {
  const size_t nodes = tin.nodes.size();
  std::vector<int32_t> part(nodes);  // of nodes of the sea: towards the first one of what hangs together
  std::iota(part.begin(), part.end(), 0);
  const auto first_of = [&](int32_t node) {
    while (part[at(node)] != node) node = part[at(node)] = part[at(part[at(node)])];
    return node;
  };
  const auto for_each_side = [&](auto&& visit) {
    for (const std::array<int32_t, 3>& t : tin.triangles) {
      for (size_t k = 0; k < 3; ++k) visit(t[k], t[(k + 1) % 3]);
    }
  };
  for_each_side([&](int32_t a, int32_t b) {
    if (tin.region[at(a)] != Tin::kOutside || tin.region[at(b)] != Tin::kOutside) return;
    const int32_t first = first_of(a), other = first_of(b);
    part[at(std::max(first, other))] = std::min(first, other);
  });
  std::vector<uint8_t> open(nodes, 0);
  for (size_t node = 0; node < nodes; ++node) {
    const Vec2 p = tin.nodes[node];
    if (tin.region[node] == Tin::kOutside && is_beyond(tin.frame, p))
      open[at(first_of(static_cast<int32_t>(node)))] = 1;
  }
  std::vector<int32_t> land(nodes, Tin::kOutside);  // the least region that a shut part touches
  for_each_side([&](int32_t a, int32_t b) {
    for (const auto& [sea, shore] : {std::pair(a, b), std::pair(b, a)}) {
      int32_t region = tin.region[at(shore)];
      if (tin.region[at(sea)] != Tin::kOutside || region == Tin::kOutside) continue;
      while (tin.regions[at(region)].parent >= 0) region = tin.regions[at(region)].parent;
      int32_t& least = land[at(first_of(sea))];
      least = least == Tin::kOutside ? region : std::min(least, region);
    }
  });
  std::vector<int32_t> closed;
  for (size_t node = 0; node < nodes; ++node) {
    const auto n = static_cast<int32_t>(node);
    if (tin.region[node] != Tin::kOutside || open[at(first_of(n))] != 0 || land[at(first_of(n))] < 0) continue;
    closed.push_back(n);
  }
  for (const int32_t node : closed) tin.region[at(node)] = land[at(first_of(node))];
  return static_cast<int64_t>(closed.size());
}

std::vector<std::string> drop_empty_regions(Tin& tin) {
  std::vector<char> full(tin.regions.size(), 0);
  for (const int32_t r : tin.region) {
    if (r >= 0) full[at(r)] = 1;
  }
  std::vector<int32_t> place(tin.regions.size(), -1);  // itself, or the nearest one around it that stays
  std::vector<TinRegion> kept;
  std::vector<std::string> dropped;
  for (size_t i = 0; i < tin.regions.size(); ++i) {
    TinRegion& region = tin.regions[i];
    const int32_t around = region.parent < 0 ? -1 : place[at(region.parent)];
    if (full[i] == 0) {
      dropped.push_back(region.name);
      place[i] = around;
      continue;
    }
    region.parent = around;
    place[i] = static_cast<int32_t>(kept.size());
    kept.push_back(std::move(region));
  }
  tin.regions = std::move(kept);
  for (int32_t& r : tin.region) r = r < 0 ? r : place[at(r)];
  return dropped;
}

void join_strays(Tin& tin, const RunContext& run) {
  constexpr int kRounds = 20;  // each gives parts to regions further in
  const geom::NodeGraph graph = geom::make_node_graph(tin.triangles, tin.nodes.size(), run);
  const std::vector<char> rim = border_of_network(tin, run);
  for (int round = 0; round < kRounds && join_once(tin, graph, rim, run); ++round) {
  }
}

}  // namespace seamount::contour

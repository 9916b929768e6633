// What is wrong with a network (marching_triangles.h). Triangles that all run counter-clockwise and share edges in
// pairs cover each place as often as the border winds around it: once, if the border's rings do not meet and run
// alternately.
#include <algorithm>
#include <cmath>

#include "seamount/base/text.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/predicates.h"
#include "seamount/geom/tin/tin_border.h"

namespace seamount::geom {
namespace {

std::string place(Vec2 p) { return "(" + format_number(p.x) + ", " + format_number(p.y) + ")"; }

std::optional<std::string> node_defect(const Tin& tin) {
  const size_t n = tin.nodes.size();
  const auto wrong = [n](size_t size) { return size != 0 && size != n; };
  if (wrong(tin.region.size()) || wrong(tin.rank.size()) || wrong(tin.height_m.size()))
    return "regions, ranks or heights are not as many as its " + std::to_string(n) + " nodes";
  for (size_t i = 0; i < n; ++i) {
    const bool sound = std::isfinite(tin.nodes[i].x) && std::isfinite(tin.nodes[i].y) &&
                       (tin.height_m.empty() || std::isfinite(tin.height_m[i])) &&
                       (tin.rank.empty() || std::isfinite(tin.rank[i]));
    if (!sound) return "node " + std::to_string(i) + " has a place, height or rank that is not finite";
    if (!tin.region.empty() &&
        (tin.region[i] < Tin::kOutside || tin.region[i] >= static_cast<int64_t>(tin.regions.size())))
      return "node " + std::to_string(i) + " lies in region " + std::to_string(tin.region[i]) + " of " +
             std::to_string(tin.regions.size());
  }
  for (size_t i = 0; i < tin.regions.size(); ++i) {
    if (tin.regions[i].parent < -1 || tin.regions[i].parent >= static_cast<int64_t>(i))
      return "region " + std::to_string(i) + " does not stand after its parent";
  }
  return std::nullopt;
}

std::optional<std::string> triangle_defect(const Tin& tin) {
  const auto n = static_cast<int64_t>(tin.nodes.size());
  for (size_t i = 0; i < tin.triangles.size(); ++i) {
    const std::array<int32_t, 3>& t = tin.triangles[i];
    for (const int32_t node : t) {
      if (node < 0 || node >= n)
        return "triangle " + std::to_string(i) + " names node " + std::to_string(node) + " of " + std::to_string(n);
    }
    const Vec2 a = tin.nodes[static_cast<size_t>(t[0])];
    const Vec2 b = tin.nodes[static_cast<size_t>(t[1])];
    const Vec2 c = tin.nodes[static_cast<size_t>(t[2])];
    if (orientation_sign(a, b, c) <= 0)
      return "triangle " + std::to_string(i) + " at " + place(a) + " does not run counter-clockwise";
  }
  return std::nullopt;
}

std::optional<std::string> edge_defect(const Tin& tin) {
  std::vector<uint64_t> edges;
  edges.reserve(3 * tin.triangles.size());
  for (const std::array<int32_t, 3>& t : tin.triangles) {
    for (size_t i = 0; i < 3; ++i)
      edges.push_back(static_cast<uint64_t>(t[i]) << 32 | static_cast<uint64_t>(t[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice == edges.end()) return std::nullopt;
  return "two triangles lie on the same side of the edge at " + place(tin.nodes[static_cast<size_t>(*twice >> 32)]);
}

std::optional<std::string> border_defect(const Tin& tin) {
  if (tin.triangles.empty()) return std::nullopt;
  std::vector<Contour> rings;
  for (const std::vector<int32_t>& nodes : border_rings(tin)) {
    Contour ring;
    for (const int32_t node : nodes) ring.ring.push_back(tin.nodes[static_cast<size_t>(node)]);
    rings.push_back(std::move(ring));
  }
  if (rings.empty()) return "its triangles lie over each other";
  if (const auto crossing = find_contour_crossing(rings))
    return "its border meets itself at " + place(crossing->at) + ": triangles lie over each other or touch at a node";
  const std::vector<int> parents = find_contour_parents(rings);
  for (size_t i = 0; i < rings.size(); ++i) {
    bool outer = true;
    for (int up = parents[i]; up >= 0; up = parents[static_cast<size_t>(up)]) outer = !outer;
    if (is_hill(rings[i]) != outer) return "its triangles lie over each other near " + place(rings[i].ring.front());
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> find_tin_defect(const Tin& tin) {
  for (auto* find : {node_defect, triangle_defect, edge_defect, border_defect}) {
    if (std::optional<std::string> defect = find(tin)) return defect;
  }
  return std::nullopt;
}

}  // namespace seamount::geom

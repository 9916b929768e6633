#include "seamount/ops/contour/edit/level_chains.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace seamount::contour {
namespace {

/// Where a level crosses an edge of the mesh.
struct Crossing {
  size_t level;
  int32_t low, high;  ///< nodes
  bool operator==(const Crossing&) const = default;
  friend bool operator<(const Crossing& a, const Crossing& b) {
    if (a.level != b.level) return a.level < b.level;
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  }
};

struct Segment {
  Crossing from, to;
};

void add_segments(const LevelMesh& mesh, const std::array<int32_t, 3>& triangle, const std::vector<double>& levels,
                  std::vector<Segment>& segments) {
  const auto height = [&](int32_t node) { return mesh.height_m[static_cast<size_t>(node)]; };
  const auto [least, most] = std::minmax({height(triangle[0]), height(triangle[1]), height(triangle[2])});
  const auto first = std::upper_bound(levels.begin(), levels.end(), least);
  const auto last = std::upper_bound(levels.begin(), levels.end(), most);
  for (auto level = first; level != last; ++level) {
    Segment segment{};
    for (size_t i = 0; i < 3; ++i) {
      const int32_t a = triangle[i];
      const int32_t b = triangle[(i + 1) % 3];
      const auto number = static_cast<size_t>(level - levels.begin());
      // Where the border of the triangle leads down, the line with higher ground on its left begins.
      if (height(a) >= *level && height(b) < *level) segment.from = {number, b, a};
      if (height(a) < *level && height(b) >= *level) segment.to = {number, a, b};
    }
    segments.push_back(segment);
  }
}

Vec2 place(const LevelMesh& mesh, const Crossing& crossing, double level) {
  const auto low = static_cast<size_t>(crossing.low);
  const auto high = static_cast<size_t>(crossing.high);
  const double t = (level - mesh.height_m[low]) / (mesh.height_m[high] - mesh.height_m[low]);
  return t < 1.0 ? mesh.nodes[low] + t * (mesh.nodes[high] - mesh.nodes[low]) : mesh.nodes[high];
}

void append(Polyline& points, Vec2 p) {
  if (points.empty() || !(points.back() == p)) points.push_back(p);
}

/// Follows segments from `start`; marks those used.
LevelChain follow(const LevelMesh& mesh, const std::vector<double>& levels, const std::vector<Segment>& segments,
                  const std::vector<ptrdiff_t>& next, size_t start, std::vector<char>& used) {
  LevelChain chain{levels[segments[start].from.level], false, {}, segments[start].from.high};
  auto at = static_cast<ptrdiff_t>(start);
  size_t last = start;
  while (at >= 0 && used[static_cast<size_t>(at)] == 0) {
    last = static_cast<size_t>(at);
    used[last] = 1;
    append(chain.points, place(mesh, segments[last].from, chain.height_m));
    at = next[last];
  }
  chain.closed = at >= 0;
  if (chain.closed) {
    while (chain.points.size() > 1 && chain.points.back() == chain.points.front()) chain.points.pop_back();
  } else {
    append(chain.points, place(mesh, segments[last].to, chain.height_m));
    chain.last_node = segments[last].to.high;
  }
  return chain;
}

}  // namespace

std::vector<LevelChain> level_chains(const LevelMesh& mesh, const std::vector<double>& levels) {
  std::vector<Segment> segments;
  for (const auto& triangle : mesh.triangles) add_segments(mesh, triangle, levels, segments);
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) { return a.from < b.from; });
  std::vector<ptrdiff_t> next(segments.size(), -1);
  std::vector<char> follows(segments.size(), 0);
  for (size_t i = 0; i < segments.size(); ++i) {
    const auto found = std::lower_bound(segments.begin(), segments.end(), segments[i].to,
                                        [](const Segment& a, const Crossing& key) { return a.from < key; });
    if (found == segments.end() || !(found->from == segments[i].to)) continue;
    next[i] = found - segments.begin();
    follows[static_cast<size_t>(next[i])] = 1;
  }
  std::vector<LevelChain> chains;
  std::vector<char> used(segments.size(), 0);
  for (size_t i = 0; i < segments.size(); ++i) {
    if (follows[i] == 0) chains.push_back(follow(mesh, levels, segments, next, i, used));
  }
  for (size_t i = 0; i < segments.size(); ++i) {
    if (used[i] == 0) chains.push_back(follow(mesh, levels, segments, next, i, used));
  }
  return chains;
}

}  // namespace seamount::contour

#include "seamount/geom/contour/marching_open_triangles.h"

#include <algorithm>
#include <cstddef>

#include "seamount/geom/contour/chains.h"

namespace seamount::geom {
namespace {

/// Where a level crosses an edge of the mesh.
struct EdgePlace {
  uint32_t level;
  int32_t low, high;  ///< nodes
  auto operator<=>(const EdgePlace&) const = default;
};

struct Piece {
  EdgePlace from, to;
};

/// The pieces of all lines, one a triangle and level, in the order of where they start.
std::vector<Piece> cut_triangles(const HeightMesh& mesh, const std::vector<double>& levels) {
  std::vector<Piece> pieces;
  const auto height = [&](int32_t node) { return mesh.height_m[static_cast<size_t>(node)]; };
  for (const std::array<int32_t, 3>& t : mesh.triangles) {
    const auto [least, most] = std::minmax({height(t[0]), height(t[1]), height(t[2])});
    for (uint32_t level = level_rank(levels, least); level < level_rank(levels, most); ++level) {
      Piece piece{};
      for (size_t i = 0; i < 3; ++i) {
        const int32_t a = t[i];
        const int32_t b = t[(i + 1) % 3];
        // Where the border of the triangle leads down, the line with higher ground on its left begins.
        if (height(a) >= levels[level] && height(b) < levels[level]) piece.from = {level, b, a};
        if (height(a) < levels[level] && height(b) >= levels[level]) piece.to = {level, a, b};
      }
      pieces.push_back(piece);
    }
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
  return pieces;
}

Vec2 place(const HeightMesh& mesh, const EdgePlace& at, double level) {
  const auto low = static_cast<size_t>(at.low);
  const auto high = static_cast<size_t>(at.high);
  const double t = (level - mesh.height_m[low]) / (mesh.height_m[high] - mesh.height_m[low]);
  return t < 1.0 ? mesh.nodes[low] + t * (mesh.nodes[high] - mesh.nodes[low]) : mesh.nodes[high];
}

/// Without points that repeat their neighbour: lines through a node have several there.
void drop_repeated(ContourChain& chain) {
  Polyline& points = chain.points;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (chain.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
}

}  // namespace

std::vector<LevelChain> march_open_triangles(const HeightMesh& mesh, const std::vector<double>& levels,
                                             const RunContext& run) {
  const std::vector<Piece> pieces = cut_triangles(mesh, levels);
  // A place is numbered as the piece that starts there; those where none does, at the border, follow.
  std::vector<EdgePlace> places;
  places.reserve(pieces.size());
  for (const Piece& piece : pieces) places.push_back(piece.from);
  std::vector<ContourSegment> segments;
  segments.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    if (segments.size() % 4096 == 0) run.check_cancelled();
    const auto end = places.begin() + static_cast<std::ptrdiff_t>(pieces.size());
    const auto found = std::lower_bound(places.begin(), end, piece.to);
    const bool goes_on = found != end && *found == piece.to;
    const auto to = static_cast<uint32_t>(goes_on ? static_cast<size_t>(found - places.begin()) : places.size());
    if (!goes_on) places.push_back(piece.to);
    segments.push_back({static_cast<uint32_t>(segments.size()), to});
  }
  std::vector<Crossing> crossings;
  crossings.reserve(places.size());
  for (const EdgePlace& at : places) crossings.push_back({place(mesh, at, levels[at.level]), at.level});
  std::vector<LevelChain> chains;
  for (ContourChain& chain : join_segments(crossings, segments, run)) {
    drop_repeated(chain);
    const int32_t first = places[chain.first].high;
    const int32_t last = chain.closed ? -1 : places[chain.last].high;
    chains.push_back({levels[chain.level], chain.closed, std::move(chain.points), first, last});
  }
  return chains;
}

}  // namespace seamount::geom

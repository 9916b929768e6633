// Distances to drawn borders (distance.h): a quadtree over the grid. A square of half diagonal R whose centre lies d
// from its nearest edge can be nearest only to edges within d + 2 R of its centre; the others are dropped on the way
// down, so a leaf of a few cells tries a handful of edges. Places are counted from the corner of the whole raster, so
// that a window has the distances of the whole to the bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/grid_edge.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

constexpr int kLeaf = 4;    ///< cells along a leaf
constexpr int kTile = 128;  ///< cells along a tile, the unit of parallel work; kLeaf times a power of two

using Edge = GridEdge<double>;

SEAMOUNT_VECTORISED void centre_distances(const Edge* edges, size_t count, double x, double y, double* squared) {
  for (size_t i = 0; i < count; ++i) squared[i] = squared_distance(edges[i], x, y);
}

/// Least distance (cells) of a leaf's cells to the edges, times scale, into out (rows of `stride`).
SEAMOUNT_VECTORISED void fill_leaf(const Edge* edges, size_t count, int x0, int y0, int width, int height, float scale,
                                   float* out, int64_t stride) {
  constexpr int kCells = kLeaf * kLeaf;
  double xs[kCells], ys[kCells], best[kCells];
  for (int i = 0; i < kCells; ++i) {
    const int row = i / kLeaf;
    xs[i] = x0 + (i - row * kLeaf);
    ys[i] = y0 + row;
    best[i] = std::numeric_limits<double>::infinity();
  }
  for (size_t k = 0; k < count; ++k) {
    const Edge edge = edges[k];
    for (int i = 0; i < kCells; ++i) {
      const double d = squared_distance(edge, xs[i], ys[i]);
      best[i] = d < best[i] ? d : best[i];
    }
  }
  float roots[kCells];
  for (int i = 0; i < kCells; ++i) roots[i] = static_cast<float>(std::sqrt(best[i])) * scale;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) out[y * stride + x] = roots[y * kLeaf + x];
  }
}

/// Works down one tile.
class Descent {
 public:
  explicit Descent(ScalarField& field)
      : field_(field),
        scale_(static_cast<float>(field.cell_m())),
        left_(field.frame().first_column()),
        top_(field.frame().first_row()) {}

  void visit(const std::vector<Edge>& edges, int x0, int y0, int size, size_t depth = 0) {
    const int width = std::min(size, field_.width() - x0);
    const int height = std::min(size, field_.height() - y0);
    if (width <= 0 || height <= 0) return;
    keep_near(edges, left_ + x0 + 0.5 * (width - 1), top_ + y0 + 0.5 * (height - 1),
              0.5 * std::hypot(width - 1, height - 1), lists_[depth]);
    if (size <= kLeaf) {
      fill_leaf(lists_[depth].data(), lists_[depth].size(), left_ + x0, top_ + y0, width, height, scale_,
                &field_(x0, y0), field_.width());
      return;
    }
    const int half = size / 2;
    for (int quarter = 0; quarter < 4; ++quarter) {
      visit(lists_[depth], x0 + (quarter % 2) * half, y0 + (quarter / 2) * half, half, depth + 1);
    }
  }

 private:
  void keep_near(const std::vector<Edge>& edges, double x, double y, double radius, std::vector<Edge>& near) {
    squared_.resize(edges.size());
    centre_distances(edges.data(), edges.size(), x, y, squared_.data());
    const double least = *std::min_element(squared_.begin(), squared_.end());
    const double reach = std::sqrt(least) + 2.0 * radius;
    const double limit = reach * reach * (1.0 + 1e-12) + 1e-12;
    near.clear();
    for (size_t i = 0; i < edges.size(); ++i) {
      if (squared_[i] <= limit) near.push_back(edges[i]);
    }
  }

  ScalarField& field_;
  float scale_;
  int left_, top_;
  std::vector<double> squared_;
  std::array<std::vector<Edge>, 8> lists_;  ///< one for each depth; kTile = kLeaf 2^depth
};

class EdgeList {
 public:
  explicit EdgeList(const GridFrame& frame) : frame_(frame.in_whole()) {}

  void add(Vec2 a, Vec2 b) {
    const double x = frame_.column(a.x);
    const double y = frame_.row(a.y);
    const double dx = frame_.column(b.x) - x;
    const double dy = frame_.row(b.y) - y;
    const double squared = dx * dx + dy * dy;
    edges_.push_back({x, y, dx, dy, squared > 0.0 ? 1.0 / squared : 0.0});
  }
  void add_ring(const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
  }
  const std::vector<Edge>& edges() const { return edges_; }

 private:
  GridFrame frame_;
  std::vector<Edge> edges_;
};

ScalarField edge_distance(const std::vector<Edge>& edges, const GridFrame& frame, const RunContext& run) {
  if (edges.empty()) return ScalarField(frame, std::numeric_limits<float>::infinity());
  ScalarField field(frame);
  const int columns = (frame.width + kTile - 1) / kTile;
  const int rows = (frame.height + kTile - 1) / kTile;
  parallel_blocks(run, static_cast<int64_t>(columns) * rows, 1, [&](int64_t begin, int64_t end) {
    Descent descent(field);
    for (int64_t tile = begin; tile < end; ++tile) {
      descent.visit(edges, static_cast<int>(tile % columns) * kTile, static_cast<int>(tile / columns) * kTile, kTile);
    }
  });
  return field;
}

}  // namespace

ScalarField signed_distance(const std::vector<Polygon>& polygons, const GridFrame& frame, const RunContext& run) {
  EdgeList list(frame);
  for (const Polygon& polygon : polygons) {
    list.add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) list.add_ring(hole);
  }
  ScalarField field = edge_distance(list.edges(), frame, run);
  if (list.edges().empty()) return field;
  const Grid<uint8_t> inside = rasterise(polygons, frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::span<const uint8_t> in = inside.row(y);
      const std::span<float> out = field.row(y);
      for (size_t x = 0; x < out.size(); ++x) out[x] = in[x] != 0 ? -out[x] : out[x];
    }
  });
  return field;
}

ScalarField distance_to_lines(const std::vector<Polyline>& lines, const GridFrame& frame, const RunContext& run) {
  EdgeList list(frame);
  for (const Polyline& line : lines) {
    if (line.size() == 1) list.add(line[0], line[0]);
    for (size_t i = 0; i + 1 < line.size(); ++i) list.add(line[i], line[i + 1]);
  }
  return edge_distance(list.edges(), frame, run);
}

}  // namespace seamount::geom

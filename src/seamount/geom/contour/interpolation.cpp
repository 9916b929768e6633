// The quadtree of border_distance.cpp with edges in groups, one for each bound of each face: a square keeps of each
// group whose face it touches those edges that can be nearest to one of its cells.
#include "seamount/geom/contour/interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/polygon/grid_edge.h"

namespace seamount::geom {
namespace {

constexpr int kLeaf = 4;    ///< cells along a leaf
constexpr int kTile = 128;  ///< cells along a tile, the unit of parallel work; kLeaf times a power of two
constexpr size_t kCells = kLeaf * kLeaf;

/// From one tile's own corner, so that floats are exact to a ten thousandth of a cell.
struct Edge : GridEdge<float> {
  uint32_t bound;
};

SEAMOUNT_VECTORISED void centre_distances(const Edge* edges, size_t count, float x, float y, float* squared) {
  for (size_t i = 0; i < count; ++i) squared[i] = squared_distance(edges[i], x, y);
}

SEAMOUNT_VECTORISED void leaf_distances(const Edge* edges, size_t count, const float* xs, const float* ys,
                                        float* best) {
  for (size_t i = 0; i < kCells; ++i) best[i] = std::numeric_limits<float>::infinity();
  for (size_t k = 0; k < count; ++k) {
    const Edge edge = edges[k];
    for (size_t i = 0; i < kCells; ++i) {
      const float d = squared_distance(edge, xs[i], ys[i]);
      best[i] = d < best[i] ? d : best[i];
    }
  }
}

/// An edge with its ends in cells of the whole grid.
struct Piece {
  Vec2 a, b;
  uint32_t bound;
};

/// The part of an edge within the frame (Liang and Barsky).
std::optional<Piece> clip(Vec2 a, Vec2 b, const GridFrame& frame) {
  const Vec2 d = b - a;
  double from = 0.0;
  double to = 1.0;
  const auto cut = [&](double direction, double room) {
    if (direction == 0.0) return room >= 0.0;
    const double t = room / direction;
    (direction < 0.0 ? from : to) = direction < 0.0 ? std::max(from, t) : std::min(to, t);
    return from <= to;
  };
  const double right = frame.width - 0.5;
  const double bottom = frame.height - 0.5;
  if (!cut(-d.x, a.x + 0.5) || !cut(d.x, right - a.x) || !cut(-d.y, a.y + 0.5) || !cut(d.y, bottom - a.y))
    return std::nullopt;
  return Piece{a + from * d, a + to * d, 0};
}

/// Each edge within the frame twice: as a bound of the face inside and of the face outside.
class BoundPieces {
 public:
  BoundPieces(const std::vector<Contour>& contours, const ContourFaces& faces, const GridFrame& frame,
              const RunContext& run)
      : starts_(faces.bounds().size() + 1, 0) {
    for (size_t c = 0; c < contours.size(); ++c) {
      const Ring& ring = contours[c].ring;
      for (size_t i = 0; i < ring.size(); ++i) {
        run.check_cancelled();
        const Vec2& p = ring[i];
        const Vec2& q = ring[i + 1 < ring.size() ? i + 1 : 0];
        std::optional<Piece> piece =
            clip({frame.column(p.x), frame.row(p.y)}, {frame.column(q.x), frame.row(q.y)}, frame);
        if (!piece) continue;
        piece->bound = static_cast<uint32_t>(faces.inner_bound(c));
        pieces_.push_back(*piece);
        piece->bound = static_cast<uint32_t>(faces.outer_bound(c));
        pieces_.push_back(*piece);
      }
    }
    std::stable_sort(pieces_.begin(), pieces_.end(), [&](const Piece& a, const Piece& b) {
      run.check_cancelled();
      return a.bound < b.bound;
    });
    for (const Piece& piece : pieces_) ++starts_[piece.bound + 1];
    for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  }

  std::span<const Piece> of(size_t bound) const {
    return std::span(pieces_).subspan(starts_[bound], starts_[bound + 1] - starts_[bound]);
  }

 private:
  std::vector<Piece> pieces_;
  std::vector<size_t> starts_;
};

/// Works down one tile.
class Descent {
 public:
  Descent(const ContourFaces& faces, ContourInterpolation& made, const RunContext& run)
      : faces_(faces), made_(made), run_(run), seen_(static_cast<size_t>(faces.count()), 0) {}

  void fill_tile(const BoundPieces& pieces, int x0, int y0) {
    left_ = x0;
    top_ = y0;
    visit(edges_of_tile(pieces), x0, y0, kTile, 0);
  }

 private:
  /// The edges of all faces in the tile, by bound.
  std::vector<Edge> edges_of_tile(const BoundPieces& pieces) {
    mark_faces(left_, top_, std::min(kTile, made_.face.width() - left_), std::min(kTile, made_.face.height() - top_));
    std::vector<Edge> edges;
    for (int32_t face = 0; face < faces_.count(); ++face) {
      if (seen_[static_cast<size_t>(face)] != stamp_) continue;
      for (size_t bound = faces_.first_bound(face); bound < faces_.first_bound(face + 1); ++bound) {
        for (const Piece& piece : pieces.of(bound)) {
          const Vec2 d = piece.b - piece.a;
          const double squared = dot(d, d);
          edges.push_back(
              {{static_cast<float>(piece.a.x - left_), static_cast<float>(piece.a.y - top_), static_cast<float>(d.x),
                static_cast<float>(d.y), squared > 1e-12 ? static_cast<float>(1.0 / squared) : 0.0F},
               static_cast<uint32_t>(bound)});
        }
      }
    }
    return edges;
  }

  void mark_faces(int x0, int y0, int width, int height) {
    ++stamp_;
    for (int y = y0; y < y0 + height; ++y)
      for (const int32_t face : made_.face.row(y).subspan(static_cast<size_t>(x0), static_cast<size_t>(width)))
        seen_[static_cast<size_t>(face)] = stamp_;
  }

  void visit(const std::vector<Edge>& edges, int x0, int y0, int size, size_t depth) {
    const int width = std::min(size, made_.face.width() - x0);
    const int height = std::min(size, made_.face.height() - y0);
    if (width <= 0 || height <= 0) return;
    run_.check_cancelled();
    mark_faces(x0, y0, width, height);
    const float reach = 0.5F * std::hypot(static_cast<float>(width - 1), static_cast<float>(height - 1));
    keep_near(edges, static_cast<float>(x0 - left_) + 0.5F * static_cast<float>(width - 1),
              static_cast<float>(y0 - top_) + 0.5F * static_cast<float>(height - 1), reach, lists_[depth]);
    if (size <= kLeaf) return fill_leaf(lists_[depth], x0, y0, width, height);
    const int half = size / 2;
    for (int quarter = 0; quarter < 4; ++quarter)
      visit(lists_[depth], x0 + (quarter % 2) * half, y0 + (quarter / 2) * half, half, depth + 1);
  }

  /// Calls visit(first, end) for the edges of each bound.
  template <class Visit>
  static void for_each_group(const std::vector<Edge>& edges, Visit&& visit) {
    for (size_t first = 0; first < edges.size();) {
      size_t end = first + 1;
      while (end < edges.size() && edges[end].bound == edges[first].bound) ++end;
      visit(first, end);
      first = end;
    }
  }

  int32_t face_of(uint32_t bound) const { return faces_.bounds()[bound].face; }

  void keep_near(const std::vector<Edge>& edges, float x, float y, float radius, std::vector<Edge>& near) {
    near.clear();
    for_each_group(edges, [&](size_t first, size_t end) {
      if (seen_[static_cast<size_t>(face_of(edges[first].bound))] != stamp_) return;
      squared_.resize(end - first);
      centre_distances(edges.data() + first, end - first, x, y, squared_.data());
      const float least = *std::min_element(squared_.begin(), squared_.end());
      const float far = std::sqrt(least) + 2.0F * radius;
      const float limit = far * far * 1.001F + 1e-3F;
      for (size_t i = first; i < end; ++i)
        if (squared_[i - first] <= limit) near.push_back(edges[i]);
    });
  }

  void fill_leaf(const std::vector<Edge>& edges, int x0, int y0, int width, int height) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    std::array<float, kCells> xs, ys, best, low, high, weights, sums;
    std::array<int32_t, kCells> faces;
    for (size_t i = 0; i < kCells; ++i) {
      const int dx = static_cast<int>(i) % kLeaf;
      const int dy = static_cast<int>(i) / kLeaf;
      xs[i] = static_cast<float>(x0 + dx - left_);
      ys[i] = static_cast<float>(y0 + dy - top_);
      faces[i] = made_.face.clamped(x0 + dx, y0 + dy);
      low[i] = high[i] = kFar;
      weights[i] = sums[i] = 0.0F;
    }
    for_each_group(edges, [&](size_t first, size_t end) {
      leaf_distances(edges.data() + first, end - first, xs.data(), ys.data(), best.data());
      const ContourFaces::Bound& bound = faces_.bounds()[edges[first].bound];
      const bool lowest = edges[first].bound == faces_.first_bound(bound.face);
      const bool highest = edges[first].bound + 1 == faces_.first_bound(bound.face + 1);
      const auto rise = static_cast<float>(bound.height_m - faces_.low_m(bound.face));
      for (size_t i = 0; i < kCells; ++i) {
        if (faces[i] != bound.face) continue;
        const float d = std::sqrt(best[i]);
        const float weight = 1.0F / std::max(d, 1e-6F);
        weights[i] += weight;
        sums[i] += weight * rise;
        if (lowest) low[i] = d;
        if (highest) high[i] = d;
      }
    });
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto i = static_cast<size_t>(y * kLeaf + x);
        const auto base = static_cast<float>(faces_.bounds_of(faces[i]) > 0 ? faces_.low_m(faces[i]) : 0.0);
        made_.height_m(x0 + x, y0 + y) = weights[i] > 0.0F ? base + sums[i] / weights[i] : base;
        made_.low(x0 + x, y0 + y) = low[i];
        made_.high(x0 + x, y0 + y) = high[i];
      }
    }
  }

  const ContourFaces& faces_;
  ContourInterpolation& made_;
  const RunContext& run_;
  int left_ = 0, top_ = 0;
  uint32_t stamp_ = 0;
  std::vector<uint32_t> seen_;  ///< per face: the last square that it was seen in
  std::vector<float> squared_;
  std::array<std::vector<Edge>, 8> lists_;  ///< one for each depth; kTile = kLeaf 2^depth
};

}  // namespace

ContourInterpolation interpolate_contours(const std::vector<Contour>& contours, const ContourFaces& faces,
                                          const GridFrame& frame, const RunContext& run) {
  ContourInterpolation made{rasterise_faces(contours, frame, run), HeightField(frame), ScalarField(frame),
                            ScalarField(frame)};
  const BoundPieces pieces(contours, faces, frame, run);
  const int columns = (frame.width + kTile - 1) / kTile;
  const int rows = (frame.height + kTile - 1) / kTile;
  parallel_blocks(run, static_cast<int64_t>(columns) * rows, 1, [&](int64_t begin, int64_t end) {
    Descent descent(faces, made, run);
    for (int64_t tile = begin; tile < end; ++tile) {
      descent.fill_tile(pieces, static_cast<int>(tile % columns) * kTile, static_cast<int>(tile / columns) * kTile);
    }
  });
  return made;
}

}  // namespace seamount::geom

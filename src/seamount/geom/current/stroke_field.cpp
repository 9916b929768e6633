#include "seamount/geom/current/stroke_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/spline.h"

namespace seamount::geom {
namespace {

constexpr double kReach = 4.0;          // widths after which a stroke is nothing: exp(-8) = 0.0003
constexpr double kNodesPerWidth = 8.0;  // read by cubic interpolation: error below 0.1 % of a stroke's strength
constexpr double kTangentBlend = 3.0;   // directions are blended over width / 3

/// A stroke as short straight pieces with their unit tangents.
struct Path {
  std::vector<Vec2> points;
  std::vector<Vec2> tangents;
  double reach = 0;
  double west = 0, east = 0, south = 0, north = 0;  ///< of all that it reaches
};

Path make_path(const Stroke& stroke, double lattice_cell) {
  Path path;
  path.reach = kReach * stroke.width_m;
  const Polyline fine = sample_catmull_rom(stroke.points, std::max(0.25 * stroke.width_m, 0.5 * lattice_cell));
  // Long straight pieces cost less; pieces longer than the reach would offer themselves to places far away.
  for (const Vec2 p : simplify_line(fine, 0.005 * stroke.width_m)) {
    if (!path.points.empty()) {
      const Vec2 from = path.points.back();
      const int pieces = std::max(1, static_cast<int>(std::ceil(std::hypot(p.x - from.x, p.y - from.y) / path.reach)));
      for (int k = 1; k < pieces; ++k) path.points.push_back(from + (static_cast<double>(k) / pieces) * (p - from));
    }
    path.points.push_back(p);
  }
  const auto unit = [](Vec2 v) { return (1.0 / std::max(1e-12, std::sqrt(dot(v, v)))) * v; };
  for (size_t i = 0; i < path.points.size(); ++i) {
    const Vec2 in = i > 0 ? unit(path.points[i] - path.points[i - 1]) : Vec2{};
    const Vec2 out = i + 1 < path.points.size() ? unit(path.points[i + 1] - path.points[i]) : Vec2{};
    path.tangents.push_back(unit(in + out));
  }
  path.west = path.south = std::numeric_limits<double>::infinity();
  path.east = path.north = -path.west;
  for (const Vec2 p : path.points) {
    path.west = std::min(path.west, p.x - path.reach);
    path.east = std::max(path.east, p.x + path.reach);
    path.south = std::min(path.south, p.y - path.reach);
    path.north = std::max(path.north, p.y + path.reach);
  }
  return path;
}

/// The parts of a polyline inside a box (Liang and Barsky 1984): the line itself where no point lies outside.
std::vector<Polyline> clipped(const Polyline& line, const Box& box) {
  std::vector<Polyline> parts(1, Polyline());
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 a = line[i], d = line[i + 1] - a;
    double from = 0.0, to = 1.0;
    const auto cut = [&](double inside, double outwards) {  // the side that is `inside` away, approached `outwards`
      if (outwards > 0) to = std::min(to, inside / outwards);
      if (outwards < 0) from = std::max(from, inside / outwards);
      if (outwards == 0 && inside < 0) to = -1.0;
    };
    cut(a.x - box.low.x, -d.x);
    cut(box.high.x - a.x, d.x);
    cut(a.y - box.low.y, -d.y);
    cut(box.high.y - a.y, d.y);
    if (from > to) continue;
    Polyline& part = from > 0.0 && !parts.back().empty() ? parts.emplace_back() : parts.back();
    if (part.empty()) part.push_back(from > 0.0 ? a + from * d : a);
    part.push_back(to < 1.0 ? a + to * d : line[i + 1]);
    if (to < 1.0) parts.emplace_back();
  }
  if (line.size() == 1) parts.back() = line;
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

/// A stroke without what lies so far away that it cannot matter: a point may be as far away as it likes, but the work
/// is that of the domain. Strokes within 16 domains of it are what they are.
std::vector<Stroke> within_sight(const Stroke& stroke, const GridFrame& frame) {
  constexpr double kSight = 16.0;
  const double reach = kSight * std::max(frame.width_m(), frame.height_m()) + kReach * stroke.width_m;
  const Vec2 centre{frame.west_m + 0.5 * frame.width_m(), frame.north_m - 0.5 * frame.height_m()};
  std::vector<Stroke> parts;
  for (Polyline& points : clipped(stroke.points, {centre - Vec2{reach, reach}, centre + Vec2{reach, reach}}))
    parts.push_back({std::move(points), stroke.width_m, stroke.strength_m});
  return parts;
}

/// A rectangle of lattice nodes.
struct Window {
  int left = 0, right = 0, top = 0, bottom = 0;  ///< right and bottom excluded
  int width() const { return right - left; }
  bool empty() const { return left >= right || top >= bottom; }
};

/// The nodes of `within` that lie in a rectangle of metres.
Window window(const GridFrame& lattice, double west, double east, double south, double north, const Window& within) {
  const auto bound = [](double v, int low, int high) {
    return static_cast<int>(std::clamp(v, static_cast<double>(low), static_cast<double>(high)));
  };
  return {bound(std::floor(lattice.column(west)), within.left, within.right),
          bound(std::ceil(lattice.column(east)) + 1, within.left, within.right),
          bound(std::floor(lattice.row(north)), within.top, within.bottom),
          bound(std::ceil(lattice.row(south)) + 1, within.top, within.bottom)};
}

/// What the pieces of a stroke say at each node of a window.
struct Nearest {
  std::vector<float> squared;  ///< squared distance to the nearest piece
  std::vector<float> tx, ty;   ///< tangents, weighted towards the nearest
};

/// A piece of a stroke as the row kernels need it: from a along ab, tangents from t to t + c.
struct Piece {
  float abx, aby, inverse, tx, ty, cx, cy;
};

/// exp(v) for v in [-87, 0] to about 1e-5, inlined into vector loops.
SEAMOUNT_INLINE float fast_exp(float v) {
  v = v > -80.0F ? v : -80.0F;
  const int32_t n = static_cast<int32_t>(v * 1.44269504F - 0.5F);
  const float r = v - static_cast<float>(n) * 0.69314718F;
  const float p = 1.0F + r * (1.0F + r * (0.5F + r * (0.16666667F + r * (0.04166667F + r * 0.00833333F))));
  return std::bit_cast<float>((n + 127) << 23) * p;
}

struct Offset {
  float squared, along;
};

/// From a place (relative to the piece's start) to the nearest point of the piece.
SEAMOUNT_INLINE Offset offset_from(const Piece& piece, float px, float py) {
  float t = (px * piece.abx + py * piece.aby) * piece.inverse;
  t = t > 0.0F ? (t < 1.0F ? t : 1.0F) : 0.0F;
  const float dx = px - t * piece.abx, dy = py - t * piece.aby;
  return {dx * dx + dy * dy, t};
}

SEAMOUNT_VECTORISED void nearest_row(const Piece piece, float px0, float dx, float py, int count,
                                     float* __restrict squared) {
  for (int i = 0; i < count; ++i) {
    const Offset o = offset_from(piece, px0 + static_cast<float>(i) * dx, py);
    squared[i] = o.squared < squared[i] ? o.squared : squared[i];
  }
}

SEAMOUNT_VECTORISED void direction_row(const Piece piece, float px0, float dx, float py, float blend, int count,
                                       const float* __restrict squared, float* __restrict tx, float* __restrict ty) {
  for (int i = 0; i < count; ++i) {
    const Offset o = offset_from(piece, px0 + static_cast<float>(i) * dx, py);
    const float weight = fast_exp(blend * (o.squared - squared[i]));
    tx[i] += weight * (piece.tx + o.along * piece.cx);
    ty[i] += weight * (piece.ty + o.along * piece.cy);
  }
}

/// Directions back to unit length where pieces agree (opposed ones cancel), times the falloff: eq. 1.3.
SEAMOUNT_VECTORISED void displace_row(const float* __restrict squared, const float* __restrict tx,
                                      const float* __restrict ty, float strength, float scale, float furthest,
                                      int count, float* __restrict east, float* __restrict north) {
  for (int i = 0; i < count; ++i) {
    const float length = std::sqrt(tx[i] * tx[i] + ty[i] * ty[i]);
    float amount = strength * fast_exp(scale * squared[i]) / (length > 1.0F ? length : 1.0F);
    amount = squared[i] < furthest ? amount : 0.0F;
    east[i] += amount * tx[i];
    north[i] += amount * ty[i];
  }
}

/// Calls row(piece, first node, px0, py, count) for each row of nodes that each piece of a path reaches.
template <class Row>
void visit_pieces(const Path& path, const GridFrame& lattice, const Window& all, Row row) {
  for (size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Vec2 a = path.points[i], b = path.points[i + 1], ab = b - a;
    const Vec2 t = path.tangents[i], c = path.tangents[i + 1] - t;
    const Piece piece{
        static_cast<float>(ab.x), static_cast<float>(ab.y), static_cast<float>(1.0 / std::max(1e-12, dot(ab, ab))),
        static_cast<float>(t.x),  static_cast<float>(t.y),  static_cast<float>(c.x),
        static_cast<float>(c.y)};
    const Window w = window(lattice, std::min(a.x, b.x) - path.reach, std::max(a.x, b.x) + path.reach,
                            std::min(a.y, b.y) - path.reach, std::max(a.y, b.y) + path.reach, all);
    for (int y = w.top; y < w.bottom; ++y) {
      const size_t node =
          static_cast<size_t>(y - all.top) * static_cast<size_t>(all.width()) + static_cast<size_t>(w.left - all.left);
      row(piece, node, static_cast<float>(lattice.x(w.left) - a.x), static_cast<float>(lattice.y(y) - a.y), w.width());
    }
  }
}

/// Adds one stroke's displacement to the lattice rows [begin, end).
void add_stroke(const Stroke& stroke, const Path& path, int begin, int end, ScalarField& east, ScalarField& north) {
  const GridFrame& lattice = east.frame();
  const Window w = window(lattice, path.west, path.east, path.south, path.north, {0, lattice.width, begin, end});
  if (w.empty()) return;
  const size_t nodes = static_cast<size_t>(w.width()) * static_cast<size_t>(w.bottom - w.top);
  const auto furthest = static_cast<float>(path.reach * path.reach);
  const auto cell = static_cast<float>(lattice.cell_m);
  const auto scale = static_cast<float>(-0.5 / (stroke.width_m * stroke.width_m));
  const auto blend = static_cast<float>(kTangentBlend * kTangentBlend) * scale;
  Nearest near{std::vector<float>(nodes, furthest), std::vector<float>(nodes), std::vector<float>(nodes)};
  visit_pieces(path, lattice, w, [&](const Piece& piece, size_t node, float px0, float py, int count) {
    nearest_row(piece, px0, cell, py, count, &near.squared[node]);
  });
  visit_pieces(path, lattice, w, [&](const Piece& piece, size_t node, float px0, float py, int count) {
    direction_row(piece, px0, cell, py, blend, count, &near.squared[node], &near.tx[node], &near.ty[node]);
  });
  for (int y = w.top; y < w.bottom; ++y) {
    const size_t node = static_cast<size_t>(y - w.top) * static_cast<size_t>(w.width());
    displace_row(&near.squared[node], &near.tx[node], &near.ty[node], static_cast<float>(stroke.strength_m), scale,
                 furthest, w.width(), &east(w.left, y), &north(w.left, y));
  }
}

}  // namespace

StrokeField::StrokeField(const std::vector<Stroke>& strokes, const GridFrame& frame, const RunContext& run) {
  std::map<int, std::vector<size_t>> classes;  // strokes by octave of width
  for (size_t i = 0; i < strokes.size(); ++i)
    classes[static_cast<int>(std::floor(std::log2(strokes[i].width_m)))].push_back(i);
  for (const auto& [octave, members] : classes) {
    const GridFrame lattice = coarser_frame(frame, std::ldexp(1.0, octave) / kNodesPerWidth);
    Layer layer{ScalarField(lattice, 0.0F), ScalarField(lattice, 0.0F)};
    std::vector<std::pair<Stroke, Path>> paths;
    for (const size_t i : members) {
      for (Stroke& part : within_sight(strokes[i], frame)) {
        Path path = make_path(part, lattice.cell_m);
        paths.emplace_back(std::move(part), std::move(path));
      }
      run.check_cancelled();
    }
    parallel_rows(run, lattice.width, lattice.height, [&](int begin, int end) {
      for (const auto& row : paths) add_stroke(row.first, row.second, begin, end, layer.east, layer.north);
    });
    layers_.push_back(std::move(layer));
  }
}

Vec2 StrokeField::at(double x, double y) const {
  Vec2 sum;
  for (const Layer& layer : layers_) {
    const double column = layer.east.frame().column(x);
    const double row = layer.east.frame().row(y);
    sum = sum + Vec2{sample_bicubic(layer.east, column, row), sample_bicubic(layer.north, column, row)};
  }
  return sum;
}

StrokeField::Rows::Rows(const StrokeField& field) {
  for (const Layer& layer : field.layers_) {
    east_.emplace_back(layer.east);
    north_.emplace_back(layer.north);
  }
}

void StrokeField::Rows::read(double x0, double dx, double y, std::span<float> east, std::span<float> north) {
  std::fill(east.begin(), east.end(), 0.0F);
  std::fill(north.begin(), north.end(), 0.0F);
  line_.resize(east.size());
  for (size_t k = 0; k < east_.size(); ++k) {
    east_[k].read(x0, dx, y, line_);
    for (size_t i = 0; i < line_.size(); ++i) east[i] += line_[i];
    north_[k].read(x0, dx, y, line_);
    for (size_t i = 0; i < line_.size(); ++i) north[i] += line_[i];
  }
}

void add_strokes(const std::vector<Stroke>& strokes, VectorField& current, const RunContext& run) {
  const GridFrame& frame = current.frame();
  for (size_t i = 0; i < strokes.size(); ++i) {
    const std::string name = "strokes[" + std::to_string(i) + "]";
    if (!(strokes[i].width_m > 0.0) || !std::isfinite(strokes[i].width_m))
      throw InvalidArgument(name, "width " + format_number(strokes[i].width_m) + " is not above 0");
    if (!std::isfinite(strokes[i].strength_m)) throw InvalidArgument(name, "its speed is no number");
    for (const Vec2 p : strokes[i].points)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InvalidArgument(name, "has a point that is no number");
    if (strokes[i].points.size() < 2) throw InvalidArgument(name, "has fewer than two points");
  }
  if (strokes.empty() || current.empty()) return;
  const StrokeField field(strokes, frame, run.part(0.0, 0.7));
  parallel_rows(run.part(0.7, 1.0), frame.width, frame.height, [&](int begin, int end) {
    StrokeField::Rows rows(field);
    std::vector<float> east(static_cast<size_t>(frame.width)), north(east);
    for (int y = begin; y < end; ++y) {
      rows.read(frame.x(0), frame.cell_m, frame.y(y), east, north);
      for (int x = 0; x < frame.width; ++x) {
        current.x(x, y) += east[static_cast<size_t>(x)];
        current.y(x, y) += north[static_cast<size_t>(x)];
      }
    }
  });
}

}  // namespace seamount::geom

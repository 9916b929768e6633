#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/current/flow_window.h"
#include "seamount/geom/current/kelvinlet_rows.h"
#include "seamount/geom/current/object_flow.h"
#include "seamount/geom/scalar/kelvinlet.h"
#include "seamount/geom/scalar/segment.h"

namespace seamount::geom {
namespace {

constexpr double kReach = 4.0;  // radii
constexpr double kBlend = 3.0;  // directions are blended over radius / 3

Vec2 unit(Vec2 v) { return (1.0 / std::max(1e-300, std::sqrt(dot(v, v)))) * v; }

/// Different points, and the direction of the curve at each.
struct Path {
  std::vector<Vec2> points, directions;

  explicit Path(const Polyline& line) {
    for (const Vec2 p : line)
      if (points.empty() || !(p == points.back())) points.push_back(p);
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec2 in = i > 0 ? unit(points[i] - points[i - 1]) : Vec2{};
      const Vec2 out = i + 1 < points.size() ? unit(points[i + 1] - points[i]) : Vec2{};
      directions.push_back(unit(in + out));
    }
  }
};

void check(const CurveFlow& curve, const std::string& name) {
  if (!(curve.radius_m > 0.0) || !std::isfinite(curve.radius_m))
    throw InvalidArgument(name, "radius " + format_number(curve.radius_m) + " is not above 0");
  if (!std::isfinite(curve.along_m_s) || !std::isfinite(curve.outwards_m_s))
    throw InvalidArgument(name, "has a speed that is no number");
  for (const Vec2 p : curve.line)
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InvalidArgument(name, "has a point that is no number");
  if (Path(curve.line).points.size() < 2) throw InvalidArgument(name, "has fewer than two different points");
}

/// Calls visit(cell, place's offset from the nearest point of the piece, share along the piece, piece) for the cells
/// that each piece of the path reaches.
template <class Visit>
void visit_pieces(const Path& path, double reach_m, const GridFrame& frame, Visit visit) {
  for (size_t piece = 0; piece + 1 < path.points.size(); ++piece) {
    const Vec2 ends[2] = {path.points[piece], path.points[piece + 1]};
    int left = 0, top = 0;
    GridFrame part;
    if (!window_around(ends, reach_m, 0, frame, left, top, part)) continue;
    for (int y = top; y < top + part.height; ++y) {
      for (int x = left; x < left + part.width; ++x) {
        const Vec2 p{frame.x(x), frame.y(y)};
        const double share = nearest_share(p, ends[0], ends[1]);
        const Vec2 offset = p - (ends[0] + share * (ends[1] - ends[0]));
        visit(static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x), offset, share, piece);
      }
    }
  }
}

/// The flow at an offset from the curve's closest place.
Vec2 flow_at(const CurveFlow& curve, Vec2 offset, Vec2 direction, double squared) {
  const double reach = kReach * curve.radius_m;
  const double share = kelvinlets::near_share(squared / (reach * reach));
  const Kelvinlet grab{KelvinletKind::grab, {}, curve.radius_m, curve.along_m_s * direction};
  const Kelvinlet scale{KelvinletKind::scale, {}, curve.radius_m, {curve.outwards_m_s, 0.0}};
  return share * (flow_of(grab, offset) + flow_of(scale, offset));
}

FlowWindow flow_of_curve(const CurveFlow& curve, const GridFrame& grid) {
  FlowWindow window;
  GridFrame frame;
  const double reach = kReach * curve.radius_m;
  if (!window_around(curve.line, reach, 0, grid, window.left, window.top, frame)) return window;
  const Path path(curve.line);
  const auto cells = static_cast<size_t>(frame.cells());
  std::vector<double> nearest(cells, reach * reach), weights(cells, 0.0);
  std::vector<Vec2> directions(cells), offsets(cells);
  visit_pieces(path, reach, frame,
               [&](size_t i, Vec2 offset, double, size_t) { nearest[i] = std::min(nearest[i], dot(offset, offset)); });
  const double blend = -0.5 * kBlend * kBlend / (curve.radius_m * curve.radius_m);
  visit_pieces(path, reach, frame, [&](size_t i, Vec2 offset, double share, size_t piece) {
    const double weight = std::exp(std::max(-60.0, blend * (dot(offset, offset) - nearest[i])));
    directions[i] =
        directions[i] + weight * ((1.0 - share) * path.directions[piece] + share * path.directions[piece + 1]);
    offsets[i] = offsets[i] + weight * offset;
    weights[i] += weight;
  });
  window.flow = {ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)};
  for (size_t i = 0; i < cells; ++i) {
    if (!(weights[i] > 0.0) || nearest[i] >= reach * reach) continue;
    const double inverse = 1.0 / weights[i];
    const Vec2 flow = flow_at(curve, inverse * offsets[i], inverse * directions[i], nearest[i]);
    window.flow.x.cells()[i] = static_cast<float>(flow.x);
    window.flow.y.cells()[i] = static_cast<float>(flow.y);
  }
  return window;
}

}  // namespace

void add_curve_flow(std::span<const CurveFlow> curves, VectorField& current, const RunContext& run) {
  for (size_t i = 0; i < curves.size(); ++i) check(curves[i], "curves[" + std::to_string(i) + "]");
  const GridFrame frame = current.frame();
  add_windows(static_cast<int64_t>(curves.size()), current, run,
              [&](int64_t i, const RunContext&) { return flow_of_curve(curves[static_cast<size_t>(i)], frame); });
}

}  // namespace seamount::geom

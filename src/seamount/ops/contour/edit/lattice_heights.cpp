#include "seamount/ops/contour/edit/lattice_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/solve/poisson.h"

namespace seamount::contour {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// What each node knows of the nearest line within a cell's length.
struct Nearest {
  explicit Nearest(const GridFrame& frame)
      : distance(frame, kFar), signed_distance(frame, 0.0F), height(frame, 0.0F), foot(frame, Vec2{}) {}
  ScalarField distance;         ///< metres; infinite where no line is near
  ScalarField signed_distance;  ///< above 0 on the higher side
  ScalarField height;           ///< of that line
  Grid<Vec2> foot;              ///< the nearest place on it
};

Vec2 unit(Vec2 a) {
  const double length = std::hypot(a.x, a.y);
  return length > 0.0 ? (1.0 / length) * a : Vec2{};
}

/// One edge a -> b of a line with the directions of the edges before and after it.
struct LineEdge {
  Vec2 a, b, before, after;
  double height_m;
};

/// Enters an edge at the nodes within a cell of it. At an end of the edge the side is judged by both edges that meet
/// there (the pseudo-normal: exact for the nearest place of a polygon).
void enter(const LineEdge& edge, const GridFrame& frame, Nearest& nearest) {
  const double cell = frame.cell_m;
  const int x0 = std::max(0, static_cast<int>(std::floor(frame.column(std::min(edge.a.x, edge.b.x)) - 1.0)));
  const int x1 =
      std::min(frame.width - 1, static_cast<int>(std::ceil(frame.column(std::max(edge.a.x, edge.b.x)) + 1.0)));
  const int y0 = std::max(0, static_cast<int>(std::floor(frame.row(std::max(edge.a.y, edge.b.y)) - 1.0)));
  const int y1 = std::min(frame.height - 1, static_cast<int>(std::ceil(frame.row(std::min(edge.a.y, edge.b.y)) + 1.0)));
  const Vec2 d = edge.b - edge.a;
  const double squared = dot(d, d);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const Vec2 p = {frame.x(x), frame.y(y)};
      const double t = squared > 0.0 ? dot(p - edge.a, d) / squared : 0.0;
      const Vec2 along = t <= 0.0 ? edge.before + unit(d) : t >= 1.0 ? unit(d) + edge.after : d;
      const Vec2 foot = edge.a + std::clamp(t, 0.0, 1.0) * d;
      const Vec2 off = p - foot;
      const auto distance = static_cast<float>(std::hypot(off.x, off.y));
      if (!(static_cast<double>(distance) <= cell) || !(distance < nearest.distance(x, y))) continue;
      nearest.distance(x, y) = distance;
      nearest.signed_distance(x, y) = cross(along, off) >= 0.0 ? distance : -distance;
      nearest.height(x, y) = static_cast<float>(edge.height_m);
      nearest.foot(x, y) = foot;
    }
  }
}

void enter(const LevelLine& line, const GridFrame& frame, Nearest& nearest) {
  const Polyline& points = *line.points;
  const size_t n = points.size();
  const size_t edges = line.closed ? n : n - 1;
  const double margin = 2.0 * frame.cell_m;
  for (size_t i = 0; i < edges; ++i) {
    const Vec2 a = points[i];
    const Vec2 b = points[(i + 1) % n];
    if (std::max(a.x, b.x) < frame.west_m - margin || std::min(a.x, b.x) > frame.east_m() + margin ||
        std::max(a.y, b.y) < frame.south_m() - margin || std::min(a.y, b.y) > frame.north_m + margin)
      continue;
    const bool first = i == 0 && !line.closed;
    const bool last = i + 1 == edges && !line.closed;
    enter({a, b, first ? Vec2{} : unit(a - points[(i + n - 1) % n]), last ? Vec2{} : unit(points[(i + 2) % n] - b),
           line.height_m},
          frame, nearest);
  }
}

/// Slope of u at a node, over two cells to each side.
double slope_at(const ScalarField& u, int x, int y) {
  const auto difference = [&](int dx, int dy) {
    return static_cast<double>(u.clamped(x + dx, y + dy)) - static_cast<double>(u.clamped(x - dx, y - dy));
  };
  return std::hypot(difference(2, 0), difference(0, 2)) / (4.0 * u.cell_m());
}

/// Bands between lines: nodes next to each other whose heights lie between the same two levels.
struct Bands {
  Grid<int32_t> number;
  struct Band {
    float lowest = kFar, highest = -kFar;  ///< of the lines at its border
    double slope_sum = 0.0, nodes = 0.0;   ///< over the nodes beside them
    float inner = 0.0F;                    ///< height of one of its nodes
  };
  std::vector<Band> all;
};

Bands find_bands(const ScalarField& u, const Nearest& nearest, const ScalarField& first,
                 const std::vector<float>& levels, const RunContext& run) {
  const GridFrame& frame = u.frame();
  Bands bands{Grid<int32_t>(frame, -1), {}};
  const auto interval = [&](int x, int y) { return std::upper_bound(levels.begin(), levels.end(), u(x, y)); };
  std::vector<std::pair<int, int>> open;
  for (int y0 = 0; y0 < frame.height; ++y0) {
    run.check_cancelled();
    for (int x0 = 0; x0 < frame.width; ++x0) {
      if (bands.number(x0, y0) >= 0) continue;
      const auto number = static_cast<int32_t>(bands.all.size());
      const auto level = interval(x0, y0);
      Bands::Band band;
      band.inner = u(x0, y0);
      bands.number(x0, y0) = number;
      open.assign(1, {x0, y0});
      for (size_t taken = 1; !open.empty(); ++taken) {
        if (taken % 16384 == 0) run.check_cancelled();
        const auto [x, y] = open.back();
        open.pop_back();
        if (nearest.distance(x, y) != kFar) {
          band.lowest = std::min(band.lowest, nearest.height(x, y));
          band.highest = std::max(band.highest, nearest.height(x, y));
          band.slope_sum += slope_at(first, x, y);
          band.nodes += 1.0;
        }
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          if (!u.contains(x + dx, y + dy) || bands.number(x + dx, y + dy) >= 0 || interval(x + dx, y + dy) != level)
            continue;
          bands.number(x + dx, y + dy) = number;
          open.emplace_back(x + dx, y + dy);
        }
      }
      bands.all.push_back(band);
    }
  }
  return bands;
}

/// Summits, hollows and saddles, whose border is of one height, rise or fall on at the slope beside it, up to less than
/// a gap: flat, they would be lost by the least change.
void shape_flats(ScalarField& u, const Grid<uint8_t>& fixed, const Nearest& nearest, const ScalarField& first,
                 std::vector<float> levels, double gap_m, const RunContext& run) {
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  const Bands bands = find_bands(u, nearest, first, levels, run);
  ScalarField room(u.frame(), 0.0F);  // its root is about the distance to the nearest line, without creases
  geom::solve_poisson(room, fixed, ScalarField(u.frame(), -2.0F), run);
  run.check_cancelled();
  const double most = 0.4 * gap_m;
  for (size_t i = 0; i < u.size(); ++i) {
    const Bands::Band& band = bands.all[static_cast<size_t>(bands.number.cells()[i])];
    if (band.lowest != band.highest || !(room.cells()[i] > 0.0F)) continue;
    const double slope = std::max(band.slope_sum / band.nodes, 1e-9);
    const double rise = most * (1.0 - std::exp(-std::sqrt(static_cast<double>(room.cells()[i])) * slope / most));
    u.cells()[i] += static_cast<float>(band.inner >= band.lowest ? rise : -rise);
  }
}

}  // namespace

std::vector<LevelLine> level_lines(const ContourSet& set) {
  std::vector<LevelLine> lines;
  for (const Contour& contour : set.contours) lines.push_back({&contour.ring, contour.height_m, true});
  return lines;
}

std::vector<LevelLine> level_lines(const Drawing& pattern) {
  std::vector<LevelLine> lines;
  for (const ValuedLine& line : pattern.lines) lines.push_back({&line.points, line.value, line.closed});
  return lines;
}

ScalarField lattice_heights(const std::vector<LevelLine>& lines, const GridFrame& frame, double gap_m, double without,
                            const RunContext& run) {
  Nearest nearest(frame);
  for (const LevelLine& line : lines) {
    run.check_cancelled();
    enter(line, frame, nearest);
  }
  run.check_cancelled();
  Grid<uint8_t> fixed(frame, 0);
  ScalarField u(frame, 0.0F);
  bool any = false;
  const auto fix_all = [&](const std::function<float(int, int)>& value) {
    for (int y = 0; y < frame.height; ++y) {
      run.check_cancelled();
      for (int x = 0; x < frame.width; ++x) {
        if (nearest.distance(x, y) == kFar) continue;
        fixed(x, y) = 1;
        any = true;
        u(x, y) = value(x, y);
      }
    }
  };
  fix_all([&](int x, int y) { return nearest.height(x, y); });
  if (!any) return ScalarField(frame, static_cast<float>(without));
  geom::solve_laplace(u, fixed, run);
  const ScalarField first = u;
  ScalarField slope(frame);
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < frame.width; ++x) slope(x, y) = static_cast<float>(slope_at(first, x, y));
  }
  // The slope is read where the line is: nodes on either side of it rise and fall alike, and a contour between them
  // runs through that place.
  const double least = 0.02 * gap_m / frame.cell_m;
  fix_all([&](int x, int y) {
    const Vec2 foot = nearest.foot(x, y);
    const double off = static_cast<double>(nearest.signed_distance(x, y));
    const auto there = static_cast<double>(geom::sample_bilinear(slope, frame.column(foot.x), frame.row(foot.y)));
    const double rise = std::clamp(std::abs(off) * std::max(there, least), 5e-3 * gap_m, 0.45 * gap_m);
    return static_cast<float>(static_cast<double>(nearest.height(x, y)) + std::copysign(rise, off));
  });
  geom::solve_laplace(u, fixed, run);
  std::vector<float> levels;
  levels.reserve(lines.size());
  for (const LevelLine& line : lines) levels.push_back(static_cast<float>(line.height_m));
  shape_flats(u, fixed, nearest, first, std::move(levels), gap_m, run);
  return u;
}

}  // namespace seamount::contour

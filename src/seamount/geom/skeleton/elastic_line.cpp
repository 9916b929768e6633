// See elastic_line.h.
#include "seamount/geom/skeleton/elastic_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "seamount/geom/skeleton/banded_solver.h"

namespace seamount::geom {
namespace {

/// Tension without its part for the length resists no turning, as its plain second derivatives would.
constexpr double kEvennessShare = 0.1;

size_t edge_count(const ElasticLine& line, size_t vertices) { return line.closed ? vertices : vertices - 1; }

/// Factors of the squared edges and of the squared second differences.
double tension_factor(const ElasticLine& line, size_t vertices) {
  return line.weight * static_cast<double>(edge_count(line, vertices)) / (line.unit_m * line.unit_m);
}
double rigidity_factor(const ElasticLine& line) {
  const double h = line.spacing_m;
  return line.weight * line.bend_m * line.bend_m / (line.unit_m * h * h * h);
}

/// Calls visit(before, at, after) for every vertex that has two neighbours.
template <class Visit>
void for_each_bend(const ElasticLine& line, size_t n, Visit&& visit) {
  if (n < 3) return;
  for (size_t i = line.closed ? 0 : 1; i < (line.closed ? n : n - 1); ++i) visit((i + n - 1) % n, i, (i + 1) % n);
}

/// Where vertex i stands among the unknowns: a ring is folded flat, so that neighbours stay near each other.
size_t place_of(const ElasticLine& line, size_t i, size_t n) {
  if (!line.closed) return i;
  return i < (n + 1) / 2 ? 2 * i : 2 * (n - 1 - i) + 1;
}

BandedSolver stiffness(const ElasticLine& line, std::span<const double> free, double damping) {
  const size_t n = free.size();
  BandedSolver matrix(n);
  const auto add = [&](size_t i, size_t j, double value) {
    if (free[i] > 0.0 && free[j] > 0.0) matrix.add(place_of(line, i, n), place_of(line, j, n), value);
  };
  for (size_t i = 0; i < n; ++i) matrix.add(i, i, damping);
  const double tension = 2.0 * tension_factor(line, n) * (line.keeps_length ? kEvennessShare : 1.0);
  for (size_t i = 0; i < edge_count(line, n); ++i) {
    const size_t j = (i + 1) % n;
    add(i, i, tension);
    add(j, j, tension);
    add(i, j, -tension);
  }
  const double rigidity = 2.0 * rigidity_factor(line);
  for_each_bend(line, n, [&](size_t before, size_t at, size_t after) {
    add(before, before, rigidity);
    add(at, at, 4.0 * rigidity);
    add(after, after, rigidity);
    add(before, at, -2.0 * rigidity);
    add(at, after, -2.0 * rigidity);
    add(before, after, rigidity);
  });
  matrix.factor();
  return matrix;
}

}  // namespace

double chain_length(std::span<const Vec2> points, bool closed) {
  double length = 0.0;
  for (size_t i = 0; i + 1 < points.size() + (closed ? 1 : 0); ++i) {
    const Vec2 edge = points[(i + 1) % points.size()] - points[i];
    length += std::hypot(edge.x, edge.y);
  }
  return length;
}

void spread_chain(std::vector<Vec2>& points, std::vector<float>& hold, double spacing_m) {
  std::vector<Vec2> spread = {points[0]};
  std::vector<float> spread_hold = {hold[0]};
  size_t from = 0;
  const size_t n = points.size();
  for (size_t to = 1; to < n; ++to) {
    if (hold[to] == 0.0F && to + 1 < n) continue;
    const std::span<const Vec2> part = std::span<const Vec2>(points).subspan(from, to - from + 1);
    const double length = chain_length(part, false);
    const int edges = std::max(1, static_cast<int>(std::lround(std::min(length / spacing_m, 1e8))));
    size_t at = 0;
    double passed = 0.0;
    const auto edge_length = [&] { return std::hypot(part[at + 1].x - part[at].x, part[at + 1].y - part[at].y); };
    for (int k = 1; k < edges; ++k) {
      const double wanted = length * k / edges;
      for (; at + 2 < part.size() && passed + edge_length() < wanted; ++at) passed += edge_length();
      const double share = std::clamp((wanted - passed) / std::max(edge_length(), 1e-300), 0.0, 1.0);
      spread.push_back(part[at] + share * (part[at + 1] - part[at]));
      spread_hold.push_back(0.0F);
    }
    spread.push_back(points[to]);
    spread_hold.push_back(hold[to]);
    from = to;
  }
  points.swap(spread);
  hold.swap(spread_hold);
}

double elastic_energy(const ElasticLine& line, std::span<const Vec2> points) {
  const size_t n = points.size();
  if (n < 2) return 0.0;
  double squares = 0.0, bends = 0.0;
  for (size_t i = 0; i < edge_count(line, n); ++i) {
    const Vec2 edge = points[(i + 1) % n] - points[i];
    squares += dot(edge, edge);
  }
  for_each_bend(line, n, [&](size_t before, size_t at, size_t after) {
    const Vec2 bend = points[before] - 2.0 * points[at] + points[after];
    bends += dot(bend, bend);
  });
  double energy = tension_factor(line, n) * squares + rigidity_factor(line) * bends;
  if (line.keeps_length) {
    const double length = chain_length(points, line.closed) / line.unit_m;
    energy -= line.weight * length * length;
  }
  return energy;
}

void add_elastic_slope(const ElasticLine& line, std::span<const Vec2> points, std::span<Vec2> slope) {
  const size_t n = points.size();
  if (n < 2) return;
  const double tension = 2.0 * tension_factor(line, n);
  const double shrink =
      line.keeps_length ? 2.0 * line.weight * chain_length(points, line.closed) / (line.unit_m * line.unit_m) : 0.0;
  for (size_t i = 0; i < edge_count(line, n); ++i) {
    const size_t j = (i + 1) % n;
    const Vec2 edge = points[j] - points[i];
    const double length = std::hypot(edge.x, edge.y);
    const Vec2 pull = (tension - (length > 0.0 ? shrink / length : 0.0)) * edge;
    slope[i] = slope[i] - pull;
    slope[j] = slope[j] + pull;
  }
  const double rigidity = 2.0 * rigidity_factor(line);
  for_each_bend(line, n, [&](size_t before, size_t at, size_t after) {
    const Vec2 bend = rigidity * (points[before] - 2.0 * points[at] + points[after]);
    slope[before] = slope[before] + bend;
    slope[at] = slope[at] - 2.0 * bend;
    slope[after] = slope[after] + bend;
  });
}

ElasticStep elastic_step(const ElasticLine& line, std::span<const Vec2> slope, std::span<const double> free,
                         double damping, const StiffMeasure& stiff) {
  const size_t n = slope.size();
  const BandedSolver matrix = stiffness(line, free, damping);
  std::vector<Vec2> step(n), along(n, Vec2{}), solved;
  const bool is_stiff = stiff.stiffness > 0.0;
  for (size_t i = 0; i < n; ++i) {
    const size_t at = place_of(line, i, n);
    step[at] = -free[i] * slope[i];
    if (is_stiff && free[i] > 0.0) along[at] = stiff.slope[i];
  }
  matrix.solve(step);
  double with_itself = 0.0;
  if (is_stiff) {  // Sherman and Morrison 1950
    solved = along;
    matrix.solve(solved);
    double with_step = 0.0;
    for (size_t i = 0; i < n; ++i) {
      with_step += dot(along[i], step[i]);
      with_itself += dot(along[i], solved[i]);
    }
    const double factor = stiff.stiffness * with_step / (1.0 + stiff.stiffness * with_itself);
    for (size_t i = 0; i < n; ++i) step[i] = step[i] - factor * solved[i];
  }
  ElasticStep result;
  result.step.resize(n);
  if (with_itself > 0.0) result.per_measure.resize(n);
  for (size_t i = 0; i < n; ++i) {
    const size_t at = place_of(line, i, n);
    result.step[i] = free[i] * step[at];
    if (with_itself > 0.0) result.per_measure[i] = (free[i] / with_itself) * solved[at];
  }
  return result;
}

}  // namespace seamount::geom

// The internal energy of a snake (P3 eq. 1.28, Kass, Witkin and Terzopoulos 1988), and steps that respect it.
//
// For a line of length l with vertices x_i in m edges, about h apart, measured against a length u and a radius r:
//   E = weight * (tension + rigidity),  tension = m sum |x_(i+1) - x_i|^2 / u^2  (the integral of |C'|^2, -> (l /
//   u)^2), rigidity = r^2 / u sum |x_(i-1) - 2 x_i + x_(i+1)|^2 / h^3  (-> the mean along u of (r * curvature)^2).
// Both are the integrals of eq. 1.28 without their units, and do not depend on the number of vertices in the limit.
#pragma once

#include <span>
#include <vector>

#include "seamount/model/drawn.h"

namespace seamount::geom {

struct ElasticLine {
  bool closed = false;
  double weight = 1.0;     ///< alpha_i, >= 0
  double unit_m = 1.0;     ///< u, > 0
  double bend_m = 0.05;    ///< r, >= 0: where a line bends with this radius, its rigidity counts 1
  double spacing_m = 0.1;  ///< h, > 0
  /// Where a target holds the length, tension counts only how unevenly the vertices lie, (l / u)^2 is left off: it
  /// would do nothing but move the target.
  bool keeps_length = true;
};

double elastic_energy(const ElasticLine& line, std::span<const Vec2> points);

/// Adds the derivative of the energy by every vertex.
void add_elastic_slope(const ElasticLine& line, std::span<const Vec2> points, std::span<Vec2> slope);

double chain_length(std::span<const Vec2> points, bool closed);

/// Puts vertices about spacing_m apart along a chain; its ends and those with a hold above 0 stay. REQUIRES: at least
/// two points, as many holds, spacing_m > 0.
void spread_chain(std::vector<Vec2>& points, std::vector<float>& hold, double spacing_m);

/// One squared measure that a step must not run against: the energy has a part about 0.5 * stiffness * (measure)^2.
struct StiffMeasure {
  double stiffness = 0.0;            ///< >= 0
  std::span<const Vec2> slope = {};  ///< derivative of the measure by every vertex
};

struct ElasticStep {
  std::vector<Vec2> step;
  std::vector<Vec2>
      per_measure;  ///< the gentlest move that changes the stiff measure by 1, to first order; may be empty
};

/// A step that lowers the energy if it is short enough: -(H + damping)^-1 slope, with the elastic energy's second
/// derivatives and those of the stiff measure in H. Vertex i takes the share free[i] of its step, none at all where
/// that is 0. Linear in the vertices. REQUIRES: damping > 0, equal sizes.
ElasticStep elastic_step(const ElasticLine& line, std::span<const Vec2> slope, std::span<const double> free,
                         double damping, const StiffMeasure& stiff);

}  // namespace seamount::geom

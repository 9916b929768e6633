// One snake (snake.h) while it is fitted: its energy, its steps, its ends.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "seamount/geom/skeleton/elastic_line.h"
#include "seamount/geom/skeleton/snake.h"
#include "seamount/geom/skeleton/step_care.h"

namespace seamount::geom {

/// A slope of one field unit over this share of u counts 1.
inline constexpr double kSlopeShare = 0.125;
/// Steeper than this many such units counts as this, softly: no cliff may tear a curve from its length.
inline constexpr double kMostSlope = 4.0;

/// Five places of the field for each vertex: its own, and those that its slope is taken from.
inline constexpr size_t kSnakeStencil = 5;

class SnakeLine {
 public:
  /// length_m: the target, 0 for none; unit_m: u of snake.h; vertices are no nearer than least_spacing_m.
  SnakeLine(const SnakeOptions& options, double length_m, double unit_m, double least_spacing_m);

  std::vector<Vec2> points;
  std::vector<float> hold;  ///< as many as points
  double spacing_m() const { return elastic_.spacing_m; }
  double field_unit = 1.0;
  std::vector<double> energies;
  bool rests() const { return care_.rests; }

  bool has_target() const { return length_m_ > 0.0; }
  double length() const { return chain_length(points, false); }
  double mean_field() const;
  /// Makes Gamma rise from the first vertex to the last.
  void turn_uphill();

  /// Places of `line`'s vertices and around them: kSnakeStencil each.
  void add_stencils(std::span<const Vec2> line, std::vector<Vec2>& places) const;
  /// Takes Gamma at the stencils of `points` and the energy from it; the descent starts anew. While a curve grows it
  /// keeps about the length that it has, else it strives for its target.
  void start(std::span<const double> stencils, bool grows);
  /// Where the vertices would go next.
  const std::vector<Vec2>& propose();
  /// Gamma at the stencils of the last proposal: goes there if that lowers the energy, else is more careful from now
  /// on.
  void judge(std::span<const double> stencils, double least_gain);

  /// Directions for a new edge at an end, and how many edges they look ahead.
  static constexpr size_t kFan = 11;
  static constexpr size_t kAhead = 3;
  static constexpr size_t kFans = 2 * kFan * kAhead;
  bool wants_edge() const { return has_target() && points.size() >= 2 && length() < length_m_ - 0.5 * spacing_m(); }
  /// The kFans places of a fan at each end, the nearest of each direction first.
  void add_fans(std::vector<Vec2>& places) const;
  /// Adds an edge in that direction of the fans that promises to lower the energy most; false if none does. The slope
  /// of Gamma at the new vertex is not known before start().
  bool add_edge(std::span<const Vec2> fans, std::span<const double> values);
  /// Takes edges away at free ends as long as it is longer than its target and that lowers the energy.
  void take_edges();

 private:
  double energy(std::span<const Vec2> line, std::span<const double> field) const {
    return energy(line, field, length_m_);
  }
  double energy(std::span<const Vec2> line, std::span<const double> field, double target_m) const;
  /// With a target the means along the curve count, else the integrals over u.
  double per_length(double length) const { return 1.0 / (has_target() ? std::max(length, 1e-300) : elastic_.unit_m); }
  double gain_factor(double length) const { return external_ / field_unit * per_length(length); }
  double steep_factor(double length) const { return gradient_ * per_length(length); }
  /// How steep the field runs along an edge, and the derivative by the slope in units.
  struct Steepness {
    double value, by_slope;
  };
  double slope_units(double rise, double length) const {
    return kSlopeShare * elastic_.unit_m / field_unit * rise / length;
  }
  static Steepness steepness(double slope) {
    const double bound = 1.0 + slope * slope / (kMostSlope * kMostSlope);
    return {slope * slope / bound, 2.0 * slope / (bound * bound)};
  }
  double shape_energy(double length, double target_m) const;
  struct Means {
    double gain = 0.0;       ///< of Gamma along the line
    double steepness = 0.0;  ///< of how steep it runs along it
  };
  Means means() const;
  std::vector<Vec2> slope_of_energy(std::vector<Vec2>& slope_of_length) const;
  bool is_clear(Vec2 p, bool at_front) const;
  void read(std::span<const double> stencils, std::vector<double>& field, std::vector<Vec2>& slope,
            std::vector<char>& fit) const;

  ElasticLine elastic_;
  double external_, shape_, gradient_, length_m_;
  double aim_m_;               ///< target of this descent
  std::vector<double> field_;  ///< Gamma at points, floor_ where unfit
  std::vector<Vec2> slope_;    ///< of Gamma
  std::vector<char> fit_;
  double floor_ = 0.0;
  StepCare care_;
  std::vector<Vec2> proposal_;
};

}  // namespace seamount::geom

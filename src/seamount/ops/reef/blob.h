// Uneven rounded outlines for knolls and cays.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::reef {

/// An ellipse of half length `radius_m` along `bearing` (radians, clockwise from north) and radius_m * flatness across,
/// with lobes.
class Blob {
 public:
  Blob(Vec2 centre, double radius_m, double flatness, double bearing, Rng& rng)
      : centre_(centre), radius_m_(radius_m), flatness_(flatness), along_{std::sin(bearing), std::cos(bearing)} {
    for (size_t i = 0; i < lobes_.size(); ++i)
      lobes_[i] = {rng.uniform(0.05, 0.5) / static_cast<double>(i + 2), rng.uniform(0.0, 2.0 * std::numbers::pi)};
  }

  /// Metres inside the outline, about; negative outside.
  double inside_m(Vec2 p) const {
    const Vec2 d = p - centre_;
    const double u = dot(d, along_), v = cross(d, along_) / flatness_;
    const double angle = std::atan2(v, u);
    double edge = 1.0;
    for (size_t i = 0; i < lobes_.size(); ++i)
      edge += lobes_[i].size * std::sin(static_cast<double>(i + 2) * angle + lobes_[i].phase);
    return (edge * radius_m_ - std::sqrt(u * u + v * v)) * flatness_;
  }

  /// visit(x, y, inside_m) for each cell of a frame whose centre lies inside.
  template <class Visit>
  void for_each_cell(const GridFrame& f, const Visit& visit) const {
    const double reach = 1.9 * radius_m_;
    const int west = std::max(0, static_cast<int>(std::floor(f.column(centre_.x - reach))));
    const int east = std::min(f.width - 1, static_cast<int>(std::ceil(f.column(centre_.x + reach))));
    const int north = std::max(0, static_cast<int>(std::floor(f.row(centre_.y + reach))));
    const int south = std::min(f.height - 1, static_cast<int>(std::ceil(f.row(centre_.y - reach))));
    for (int y = north; y <= south; ++y) {
      for (int x = west; x <= east; ++x) {
        const double inside = inside_m({f.x(x), f.y(y)});
        if (inside > 0) visit(x, y, inside);
      }
    }
  }

 private:
  struct Lobe {
    double size = 0.0, phase = 0.0;
  };
  Vec2 centre_;
  double radius_m_, flatness_;
  Vec2 along_;
  std::array<Lobe, 4> lobes_;
};

}  // namespace seamount::reef

// Regularised Kelvinlets (de Goes and James 2017; P3 sec. 1.6.3): how an elastic medium gives way around a point, used
// as flow around objects. The three-dimensional forms, read in the horizontal plane through their centre.
//
// P3 prints s_epsilon without the factor 3 eps^2: the right one is used here.
#pragma once

#include <cmath>
#include <numbers>

#include "seamount/model/drawn.h"

namespace seamount::geom {

/// a = 1 / (4 pi shear_modulus) and b = a / (4 (1 - poisson_ratio)).
struct ElasticMedium {
  double a, b;

  /// REQUIRES: shear_modulus > 0, poisson_ratio < 1 (0.5: cannot be compressed).
  static ElasticMedium of(double shear_modulus, double poisson_ratio) {
    const double a = 1.0 / (4.0 * std::numbers::pi * shear_modulus);
    return {a, a / (4.0 * (1.0 - poisson_ratio))};
  }
};

/// 1 / r_eps^3 + 3 eps^2 / (2 r_eps^5) with r_eps^2 = |r|^2 + eps^2: what scale and twist share. REQUIRES: eps > 0.
inline double kelvinlet_falloff(double squared, double eps) {
  const double inverse = 1.0 / std::sqrt(squared + eps * eps);
  const double cube = inverse * inverse * inverse;
  return cube + 1.5 * eps * eps * cube * inverse * inverse;
}

/// (2b - a) falloff s r, at r from the centre. For s > 0 inwards, since 2b <= a.
inline Vec2 scale_kelvinlet(Vec2 r, double eps, ElasticMedium medium, double s) {
  return ((2.0 * medium.b - medium.a) * kelvinlet_falloff(dot(r, r), eps) * s) * r;
}

/// -a falloff (q x r), q vertical: for q > 0 clockwise as seen from above.
inline Vec2 twist_kelvinlet(Vec2 r, double eps, ElasticMedium medium, double q) {
  return (-medium.a * kelvinlet_falloff(dot(r, r), eps) * q) * Vec2{-r.y, r.x};
}

/// [(a - b) / r_eps + a eps^2 / (2 r_eps^3)] F + b / r_eps^3 r (r . F).
inline Vec2 grab_kelvinlet(Vec2 r, double eps, ElasticMedium medium, Vec2 force) {
  const double inverse = 1.0 / std::sqrt(dot(r, r) + eps * eps);
  const double cube = inverse * inverse * inverse;
  return ((medium.a - medium.b) * inverse + 0.5 * medium.a * eps * eps * cube) * force +
         (medium.b * cube * dot(r, force)) * r;
}

/// The largest of falloff |r| eps^2, at |r| = 0.571538 eps: where 2 t^4 + 7 t^2 = 5/2.
constexpr double kLargestFalloff = 0.7969356;

enum class KelvinletKind : unsigned char { scale, twist, grab };

/// A Kelvinlet whose strength is a speed, so that neither moduli nor forces need be known.
struct Kelvinlet {
  KelvinletKind kind = KelvinletKind::scale;
  Vec2 centre;                 ///< metres
  double radius_m = 1.0;       ///< eps, > 0
  Vec2 speed_m_s;              ///< grab: the flow at the centre. scale: x is the largest speed, outwards where positive
                               ///< (0.57 radii from the centre); twist: the same, counter-clockwise where positive
  double poisson_ratio = 0.5;  ///< of a grab, in [0, 0.5]: at 0.5 the flow goes round instead of being squeezed
};

/// Metres a second at a place. scale and twist fall with the square of the distance, grab with the distance itself.
inline Vec2 flow_of(const Kelvinlet& k, Vec2 place) {
  const Vec2 r = place - k.centre;
  const double eps = k.radius_m;
  if (k.kind == KelvinletKind::grab) {
    const ElasticMedium medium{1.0, 0.25 / (1.0 - k.poisson_ratio)};
    return grab_kelvinlet(r, eps, medium, (eps / (1.5 - medium.b)) * k.speed_m_s);
  }
  const double strength = k.speed_m_s.x * eps * eps / kLargestFalloff * kelvinlet_falloff(dot(r, r), eps);
  return strength * (k.kind == KelvinletKind::scale ? r : Vec2{-r.y, r.x});
}

}  // namespace seamount::geom

// One coarse shape of the ground as a function of the distance to a skeleton (P3 sec. 1.6.2).
//
// At a place p at distance d from a skeleton (negative inside a region for `island`; 0 there for the others but
// `cylinder`, whose axis is the outline), with t the height of the effect, h half its width, s its slope, x = d / h:
//   cone, ridge      t (1 - x)
//   dome, cylinder   t sqrt(1 - x^2)
//   bump             t (e^(-4.5 x^2) - e^-4.5) / (1 - e^-4.5)
//   plateau          min(t, s' (h - d)) with s' = max(s, t / h)
//   island           t (1 - (1 - y)^2) at y = -d / h, at most 1, within a region; of points and curves t (1 - x^2)
//   carve            a plateau downwards, whatever the sign of t, and of the surface group, whatever its group
// Surface shapes (t of either sign) are 0 from h on, and added. Grounded and altitude shapes are heights over z = 0 and
// over the water level; from h on they fall with slope s until `deepest_m`. One whose top lies at or below that level
// (t <= 0: a reef that keeps under water) is flat at t to the distance h, whatever its shape, and falls beyond.
// Rough shapes read d moved to and fro by noise, the same for all shapes at a place, so that no outline is drawn with a
// compass; d of a skeleton without inside stays at least 0.
#pragma once

#include <algorithm>
#include <cmath>

#include "seamount/geom/scalar/blend.h"
#include "seamount/model/class_effects.h"
#include "seamount/model/skeleton.h"

namespace seamount::geom {

namespace detail {
inline constexpr double kBumpEnd = 0.011108996538242306;  // exp(-4.5)
}  // namespace detail

/// What all shapes of a scene share. A window of it takes the scene's, and gets the same surface.
struct ProxyGround {
  double deepest_m = 0.0;  ///< flanks end here: the lowest height of the scene's ground
  double water_level_m = 0.0;
  double blend_m = 1.0;  ///< 1 / (2 k), >= 0
};

/// A shape as a function of the distance; for tests and previews.
class ProxyProfile {
 public:
  /// Throws InvalidArgument for numbers that are not finite, a width or slope that is not above 0.
  ProxyProfile(const HeightEffect& effect, SkeletonKind kind, const ProxyGround& ground);

  double height(double distance) const;  ///< over z = 0; of the surface group over the ground
  double weight(double distance) const;  ///< 1 up to the reach, 0 from end() on
  double end() const { return reach_ + rim_ + roughness_; }
  /// The distance as the shape reads it at a place.
  double roughened(double distance, Vec2 place) const { return roughness_ > 0.0 ? moved(distance, place) : distance; }
  double blend() const { return blend_; }
  double size() const { return size_; }
  HeightGroup group() const { return group_; }
  bool is_signed() const { return is_signed_; }  ///< distances are negative inside the region
  bool is_filled() const { return is_filled_; }  ///< or 0 there
  bool is_nothing() const { return is_nothing_; }

 private:
  double within(double distance) const;
  double moved(double distance, Vec2 place) const;

  HeightShape shape_;
  HeightGroup group_;
  double top_, level_, half_, slope_, reach_, rim_, blend_, size_, roughness_;
  bool is_signed_, is_filled_, is_nothing_;
};

inline double ProxyProfile::within(double distance) const {
  const double x = distance / half_;
  switch (shape_) {
    case HeightShape::cone:
    case HeightShape::ridge:
      return top_ * (1.0 - x);
    case HeightShape::dome:
    case HeightShape::cylinder:
      return top_ * std::sqrt(std::max(0.0, 1.0 - x * x));
    case HeightShape::bump:
      return top_ * (std::exp(-4.5 * x * x) - detail::kBumpEnd) / (1.0 - detail::kBumpEnd);
    case HeightShape::island:
      return top_ * (1.0 - x * x);
    case HeightShape::plateau:
    case HeightShape::carve: {
      const double rise = std::max(slope_, std::abs(top_) / half_) * (half_ - distance);
      return top_ < 0.0 ? std::max(top_, -rise) : std::min(top_, rise);
    }
    case HeightShape::none:
      break;
  }
  return 0.0;
}

inline double ProxyProfile::height(double distance) const {
  const bool surface = group_ == HeightGroup::surface;
  if (!surface && top_ <= 0.0) return level_ + top_ - slope_ * std::max(0.0, distance - half_);
  if (is_signed_) {
    const double inland = std::clamp(-distance / half_, 0.0, 1.0);
    if (distance <= 0.0) return level_ + top_ * inland * (2.0 - inland);
    return surface ? 0.0 : level_ - slope_ * distance;
  }
  if (distance < half_) return level_ + within(distance);
  return surface ? 0.0 : level_ - slope_ * (distance - half_);
}

inline double ProxyProfile::weight(double distance) const {
  if (distance <= reach_) return 1.0;
  return rim_ > 0.0 ? smoothstep((reach_ + rim_ - distance) / rim_) : 0.0;
}

}  // namespace seamount::geom

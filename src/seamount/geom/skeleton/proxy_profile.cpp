// See proxy_profile.h.
#include "seamount/geom/skeleton/proxy_profile.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

/// Breadth of the rim as a share of the reach.
constexpr double kRim = 0.25;
/// Largest blend as a share of a shape's size.
constexpr double kBlendShare = 0.1;
/// Largest forms of the roughness, in amplitudes.
constexpr double kRoughForms = 6.0;
constexpr Seed kRoughSeed{0x726f756768ULL};

}  // namespace

ProxyProfile::ProxyProfile(const HeightEffect& effect, SkeletonKind kind, const ProxyGround& ground)
    : shape_(effect.shape), group_(effect.shape == HeightShape::carve ? HeightGroup::surface : effect.group) {
  if (!std::isfinite(effect.height_m)) throw InvalidArgument("height_m", "must be a number");
  if (!(effect.width_m > 0.0) || !std::isfinite(effect.width_m)) throw InvalidArgument("width_m", "must be above 0");
  if (!(effect.slope > 0.0) || !std::isfinite(effect.slope)) throw InvalidArgument("slope", "must be above 0");
  if (!(effect.roughness_m >= 0.0) || !std::isfinite(effect.roughness_m))
    throw InvalidArgument("roughness_m", "must not be negative");
  roughness_ = effect.roughness_m;
  top_ = shape_ == HeightShape::carve ? -std::abs(effect.height_m) : effect.height_m;
  half_ = 0.5 * effect.width_m;
  slope_ = effect.slope;
  level_ = group_ == HeightGroup::altitude || group_ == HeightGroup::platform ? ground.water_level_m : 0.0;
  const bool surface = group_ == HeightGroup::surface;
  const double drop = surface ? 0.0 : std::max(0.0, level_ + std::min(top_, 0.0) - ground.deepest_m);
  is_nothing_ = shape_ == HeightShape::none || (surface && top_ == 0.0);
  is_signed_ = shape_ == HeightShape::island && kind == SkeletonKind::region;
  is_filled_ = kind == SkeletonKind::region && !is_signed_ && shape_ != HeightShape::cylinder;
  const bool shore = is_signed_ && (surface || top_ > 0.0);  // the outline itself is the foot
  reach_ = (shore ? 0.0 : half_) + drop / slope_;
  rim_ = surface ? 0.0 : kRim * std::max(reach_, half_);
  size_ = std::max(std::abs(top_), drop);
  if (!(size_ > 0.0)) size_ = std::max(half_ * slope_, 1e-3);
  blend_ = std::clamp(kBlendShare * size_, 1e-6, std::max(ground.blend_m, 1e-6));
}

double ProxyProfile::moved(double distance, Vec2 place) const {
  constexpr double kFbmDeviation = 0.35;
  // Flanks far out are smooth again, and cost no noise.
  const double beyond = (std::abs(distance) - half_ - roughness_) / (3.0 * roughness_);
  if (beyond >= 1.0) return distance;
  const double amplitude = roughness_ * (1.0 - smoothstep(beyond));
  const Fbm forms{.wavelength_m = kRoughForms * roughness_, .octaves = 6};
  const double noise = fbm(kRoughSeed, forms, place.x, place.y) / (2.0 * kFbmDeviation);
  const double read = distance + amplitude * std::clamp(noise, -1.0, 1.0);
  return is_signed_ ? read : std::max(0.0, read);
}

}  // namespace seamount::geom

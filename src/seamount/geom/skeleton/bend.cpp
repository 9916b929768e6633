// See bend.h.
#include "seamount/geom/skeleton/bend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/kelvinlet.h"
#include "seamount/geom/scalar/segment.h"
#include "seamount/geom/skeleton/tangles.h"

namespace seamount::geom {
namespace {

/// Beyond this many radii edges are not split: a Gaussian is below 1e-3 there.
constexpr double kReach = 4.0;
constexpr double kMostPoints = 1e6;

void check(const BendHandle& handle) {
  const auto finite = [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  if (!finite(handle.at)) throw InvalidArgument("at", "must be a place");
  if (!finite(handle.by)) throw InvalidArgument("by", "must be a displacement in metres");
  if (!(handle.radius_m > 0.0) || !std::isfinite(handle.radius_m)) {
    throw InvalidArgument("radius_m", "must be above 0");
  }
  if (!(handle.poisson_ratio >= 0.0 && handle.poisson_ratio <= 0.5)) {
    throw InvalidArgument("poisson_ratio", std::to_string(handle.poisson_ratio) + " is outside [0, 0.5]");
  }
}

/// The same line with more points where the handle takes hold.
Skeleton refined(const Skeleton& skeleton, const BendHandle& handle) {
  Skeleton result = {skeleton.kind, {}, {}};
  const size_t n = skeleton.points.size();
  const bool closed = skeleton.kind == SkeletonKind::region && n > 2;
  const auto hold_of = [&](size_t i) { return skeleton.hold.empty() ? 0.0F : skeleton.hold[i]; };
  for (size_t i = 0; i < n; ++i) {
    result.points.push_back(skeleton.points[i]);
    result.hold.push_back(hold_of(i));
    if (skeleton.kind == SkeletonKind::point || (i + 1 == n && !closed)) continue;
    const size_t j = (i + 1) % n;
    const Vec2 a = skeleton.points[i], edge = skeleton.points[j] - a;
    const double reach = kReach * handle.radius_m;
    if (squared_distance_to_segment(handle.at, a, skeleton.points[j]) > reach * reach) continue;
    const double wanted = std::ceil(std::hypot(edge.x, edge.y) / (handle.radius_m / 3.0));
    if (wanted + static_cast<double>(result.points.size()) > kMostPoints) {
      throw InvalidArgument("radius_m", "is too small for edges this long: it would take over a million points");
    }
    for (int k = 1; k < static_cast<int>(wanted); ++k) {
      result.points.push_back(a + (k / wanted) * edge);
      result.hold.push_back(std::min(hold_of(i), hold_of(j)));
    }
  }
  return result;
}

void let_go_of_empty_holds(Skeleton& skeleton) {
  if (std::all_of(skeleton.hold.begin(), skeleton.hold.end(), [](float h) { return h == 0.0F; })) skeleton.hold.clear();
}

}  // namespace

Vec2 displacement(const BendHandle& handle, Vec2 place) {
  const Vec2 r = place - handle.at;
  const double squared = dot(r, r), e = handle.radius_m;
  if (handle.kind == Handle::gaussian) return std::exp(-squared / (2.0 * e * e)) * handle.by;
  return flow_of({KelvinletKind::grab, handle.at, e, handle.by, handle.poisson_ratio}, place);
}

Skeleton moved(const Skeleton& skeleton, Vec2 by) {
  Skeleton result = skeleton;
  for (Vec2& p : result.points) p = p + by;
  return result;
}

Skeleton bent(const Skeleton& skeleton, const BendHandle& handle, bool lock) {
  check(handle);
  Skeleton result = refined(skeleton, handle);
  const double length = std::hypot(handle.by.x, handle.by.y);
  for (size_t i = 0; i < result.points.size(); ++i) {
    const Vec2 by = displacement(handle, result.points[i]);
    result.points[i] = result.points[i] + by;
    if (lock && length > 0.0 && std::hypot(by.x, by.y) > 0.5 * length) result.hold[i] = 1.0F;
  }
  let_go_of_empty_holds(result);
  if (skeleton.kind == SkeletonKind::point) return result;
  const bool region = skeleton.kind == SkeletonKind::region;
  const auto tangles = find_tangles(result.points, region);
  if (!tangles.empty() && find_tangles(skeleton.points, region).empty()) {
    throw InvalidArgument("by", "the line would cross itself near " + format_place(result.points[tangles[0].first]) +
                                    "; take a shorter step or a larger radius");
  }
  if (region && signed_area(result.points) * signed_area(skeleton.points) < 0.0) {
    throw InvalidArgument("by", "the outline would turn inside out; take a shorter step or a larger radius");
  }
  return result;
}

Skeleton held(const Skeleton& skeleton, Vec2 at, double radius_m, double hold) {
  if (!(hold >= 0.0 && hold <= 1.0)) throw InvalidArgument("hold", std::to_string(hold) + " is outside [0, 1]");
  if (!(radius_m >= 0.0)) throw InvalidArgument("radius_m", "must not be negative");
  Skeleton result = skeleton;
  result.hold.resize(result.points.size(), 0.0F);
  for (size_t i = 0; i < result.points.size(); ++i) {
    const Vec2 off = result.points[i] - at;
    if (std::hypot(off.x, off.y) <= radius_m) result.hold[i] = static_cast<float>(hold);
  }
  let_go_of_empty_holds(result);
  return result;
}

}  // namespace seamount::geom

// From the contour below the ground rises at the slope about the place (ground_slope.h), from the contour above it
// falls at that slope, and the two are blended across the band (Hormann, Spinello and Schroeder 2003 do so with cubics
// along the way between the nearest points):
//
//   h = h_k + I ((1 - b) s(m d_k / I) + b (1 - s(m d_{k+1} / I))),  b = 3 t^2 - 2 t^3,
//   t = d_k / (d_k + d_{k+1}), I = h_{k+1} - h_k, s saturating below 1,
//
// so heights meet each contour with the same slope from both sides and stay between the levels, while spurs and valleys
// between two branches of one contour, which the plain interpolation leaves almost level, go on as steep as the slopes
// beside them. On hillsides, where the ways to both contours are opposite, a cubic holds instead whose ends are at most
// twice as steep as its mean, so that no tread lies below a break of slope. Creases on the medial axes stay: they are
// the ridges and the valleys. Wide valleys, which neither slope reaches the middle of, tilt from their head to their
// mouth, and nothing leaves the plain interpolation by half an interval. A plate's few sweeps take the noise of the
// distances out.
//
// Hollows that this leaves are raised to where their water leaves, and tilted to there, not cut through: nothing but
// distances counts, and a little noise in the contours changes heights by little. What no ground can be raised for (a
// valley that is narrower than a cell between steep sides) is cut at last.
#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/solve/drain.h"
#include "seamount/geom/solve/raise_sinks.h"
#include "seamount/geom/solve/thin_plate.h"
#include "seamount/ops/contour/convert/face_ground.h"
#include "seamount/ops/contour/convert/ground_slope.h"

namespace seamount::contour {
namespace {

constexpr float kBeside = 6.0F;  ///< cells over which the slope beside a contour fades into that of open ground

/// The height of one cell.
class Blend {
 public:
  Blend(const FaceGround& ground, const GroundSlope& slopes) : ground_(ground), slopes_(slopes) {}

  float at(int x, int y) const {
    const int32_t face = ground_.between.face(x, y);
    const float low = ground_.between.low(x, y);
    const float high = ground_.between.high(x, y);
    const auto foot = static_cast<float>(ground_.faces.bounds_of(face) > 0 ? ground_.faces.low_m(face) : 0.0);
    if (ground_.open(face)) return foot + ground_.sign(face) * leave(x, y, face, low);
    if (ground_.faces.bounds_of(face) != 2 || !std::isfinite(low) || !std::isfinite(high))
      return ground_.between.height_m(x, y);
    const float rise = static_cast<float>(ground_.faces.high_m(face)) - foot;
    const float t = low / std::max(low + high, 1e-6F);
    const float slope = slopes_.at(x, y, std::min(low, high)) / rise;
    const float up = saturated_late(slope * low);
    const float down = saturated_late(slope * high);
    const float share = up + (1.0F - down - up) * geom::smoothstep(t);
    // Where both contours are further off than their slopes reach, in wide valleys and on wide spurs, the ground lies
    // level by either; it tilts from one to the other.
    const float wide = geom::smoothstep((slope * std::min(low, high) - kReach) / kReach);
    float off = share + wide * (0.5F + kLevel * (t - 0.5F) - share) - t;
    if (const float steep = slope * (low + high); steep > 1.0F)
      off += hillside(x, y) * rest(steep) * (cubic(t, steep) - t - off);
    return foot + rise * (t + kMostOff * saturated_late(off / kMostOff));
  }

 private:
  static constexpr float kReach = 1.5F;     ///< of slopes, in intervals
  static constexpr float kLevel = 0.6F;     ///< share of the interval over which such ground tilts
  static constexpr float kMostOff = 0.45F;  ///< from the plain interpolation, in intervals

  /// On a hillside the ground falls from contour to contour, by a cubic whose ends are at most twice as steep as its
  /// mean: steeper, and the rest would be level, a terrace along the foot of every range.
  static float cubic(float t, float steep) {
    constexpr float kMost = 2.0F;
    const float end = std::min(steep, kMost);
    return t * (end + t * (3.0F - 3.0F * end + t * (2.0F * end - 2.0F)));
  }

  /// How far a slope is from that of the plain interpolation.
  static float rest(float steep) { return geom::smoothstep((steep - 1.0F) / 0.3F); }

  /// 1 where the ways to both contours are opposite; 0 in valleys and on spurs between branches of one contour.
  float hillside(int x, int y) const {
    const Way down = way(ground_.between.low, x, y), up = way(ground_.between.high, x, y);
    return geom::smoothstep((-(down.x * up.x + down.y * up.y) - 0.75F) / 0.2F);
  }

  struct Way {
    float x, y;
  };
  /// The gradient of a distance, within the cell's face.
  Way way(const HeightField& distance, int x, int y) const {
    const int32_t face = ground_.between.face(x, y);
    const auto along = [&](int dx, int dy) {
      const auto inside = [&](int sign) {
        const int nx = x + sign * dx, ny = y + sign * dy;
        return distance.contains(nx, ny) && ground_.between.face(nx, ny) == face && std::isfinite(distance(nx, ny));
      };
      const int after = inside(1) ? 1 : 0, before = inside(-1) ? 1 : 0;
      if (after + before == 0) return 0.0F;
      return (distance(x + after * dx, y + after * dy) - distance(x - before * dx, y - before * dy)) /
             static_cast<float>(after + before);
    };
    return {along(1, 0), along(0, 1)};
  }

  /// How far the ground of a face with one bound leaves it.
  float leave(int x, int y, int32_t face, float low) const {
    const auto f = static_cast<size_t>(face);
    const float reach = ground_.reach_m[f];
    if (!std::isfinite(low)) return 0.5F * reach;
    const float beside = slopes_.at(x, y, low);
    const float own = beside > 0.0F ? beside - ground_.slope[f] : 0.0F;
    return reach * saturated(low * (ground_.slope[f] + own * std::exp(-low / kBeside)) / reach);
  }

  const FaceGround& ground_;
  const GroundSlope& slopes_;
};

/// How far smoothing may move heights: less next to a contour, and never beyond the levels.
struct Bounds {
  HeightField low, high;
};
Bounds smoothing_bounds(const FaceGround& ground, const HeightField& heights, const RunContext& run) {
  constexpr float kShare = 0.2F;
  constexpr float kFull = 2.0F;  ///< cells from a contour at which heights may move by the whole share
  Bounds bounds{HeightField(heights.frame()), HeightField(heights.frame())};
  parallel_rows(run, heights.width(), heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < heights.width(); ++x) {
        const int32_t face = ground.between.face(x, y);
        const float z = heights(x, y);
        const float near = std::min({ground.between.low(x, y), ground.between.high(x, y), kFull}) / kFull;
        float room = kShare * near * ground.reach_m[static_cast<size_t>(face)];
        float least = -1e30F;
        float most = 1e30F;
        if (ground.faces.bounds_of(face) > 1) {
          least = static_cast<float>(ground.faces.low_m(face));
          most = static_cast<float>(ground.faces.high_m(face));
          room = kShare * near * (most - least);
        } else if (ground.open(face)) {
          (ground.faces.rises(face) ? least : most) = static_cast<float>(ground.faces.low_m(face));
        }
        bounds.low(x, y) = std::min(z, std::max(z - room, least));
        bounds.high(x, y) = std::max(z, std::min(z + room, most));
      }
    }
  });
  return bounds;
}

/// No ground that is raised leaves its levels.
geom::Rising rising(const FaceGround& ground, double usual_m) {
  constexpr double kTilt = 1e-3;        ///< of the usual interval, a cell
  constexpr double kMostTilted = 0.25;  ///< of a pit's depth
  return {static_cast<float>(kTilt * usual_m), static_cast<float>(kMostTilted), [&ground](int64_t cell) {
            const int32_t face = ground.between.face.cells()[static_cast<size_t>(cell)];
            if (ground.faces.bounds_of(face) == 0) return 1e30F;
            const auto high = static_cast<float>(ground.faces.high_m(face));
            if (!ground.open(face)) return high;
            return ground.faces.rises(face) ? high + ground.reach_m[static_cast<size_t>(face)] : high;
          }};
}

/// Raises what would hold water; smoothing may not lower it again.
void raise(const FaceGround& ground, const geom::Rising& rising, HeightField& heights, Bounds& bounds,
           const RunContext& run) {
  const HeightField before = heights;
  geom::raise_sinks(heights, basin_floors(ground, heights), rising, run.part(0.0, 0.8));
  parallel_rows(run.part(0.8, 1.0), heights.width(), heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < heights.width(); ++x) {
        const float z = heights(x, y);
        if (z == before(x, y)) continue;
        bounds.low(x, y) = z;
        bounds.high(x, y) = std::max(z, bounds.high(x, y));
      }
    }
  });
}

/// Smooths; raises what would hold water, and smooths again without taking that away; drains what is left.
HeightField settle(const FaceGround& ground, HeightField heights, Bounds bounds, double usual_m,
                   const RunContext& run) {
  constexpr int kFirstSweeps = 3;
  constexpr int kSweeps = 7;
  const geom::Rising raising = rising(ground, usual_m);
  heights = geom::smooth_thin_plate(std::move(heights), bounds.low, bounds.high, kFirstSweeps, run.part(0.0, 0.2));
  raise(ground, raising, heights, bounds, run.part(0.2, 0.45));
  heights = geom::smooth_thin_plate(std::move(heights), bounds.low, bounds.high, kSweeps, run.part(0.45, 0.7));
  bounds = {};
  geom::raise_sinks(heights, basin_floors(ground, heights), raising, run.part(0.7, 0.85));
  geom::drain(heights, basin_floors(ground, heights), run.part(0.85, 1.0));
  return heights;
}

}  // namespace

HeightField smooth_surface(const ContourSet& set, FaceGround ground, const RunContext& run) {
  HeightField heights(ground.between.face.frame());
  {
    const GroundSlope slopes(ground, run.part(0.0, 0.05));
    const Blend blend(ground, slopes);
    parallel_rows(run.part(0.05, 0.1), heights.width(), heights.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < heights.width(); ++x) heights(x, y) = blend.at(x, y);
      }
    });
  }
  ground.between.height_m = {};
  Bounds bounds = smoothing_bounds(ground, heights, run.part(0.1, 0.15));
  ground.between.low = ground.between.high = {};
  return settle(ground, std::move(heights), std::move(bounds), usual_interval(set), run.part(0.15, 1.0));
}

}  // namespace seamount::contour

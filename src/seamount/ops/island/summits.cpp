#include "seamount/ops/island/summits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/scalar/spline.h"

namespace seamount::island {
namespace {

constexpr int kSamples = 1024;

/// A peak as the lattice sees it.
struct Cone {
  Vec2 place;
  float share = 0;     ///< of the highest's height over the foot
  float distance = 0;  ///< from its place to the foot
  Vec2 bend;           ///< at its place
  geom::CurveTable profile;
};

/// A curve over [0, 1] as shares of its highest value over that at 1.
geom::CurveTable normalised(const Curve& curve) {
  const geom::CurveFunction f(curve, geom::CurveKind::monotone_cubic, "summits.profile");
  const double foot = f(1.0);
  double highest = foot;
  for (int i = 0; i <= kSamples; ++i) highest = std::max(highest, f(static_cast<double>(i) / kSamples));
  Curve shares;
  for (int i = 0; i <= kSamples; ++i) {
    const double x = static_cast<double>(i) / kSamples;
    shares.knots.push_back({x, highest > foot ? std::max(0.0, (f(x) - foot) / (highest - foot)) : 1.0 - x});
  }
  return geom::CurveTable(geom::CurveFunction(shares, geom::CurveKind::linear), 0.0, 1.0, kSamples + 1);
}

/// 1 - x for the share s that a strictly descending shape has at x, as a function of s.
geom::CurveTable inverse(const geom::CurveFunction& shape) {
  Curve curve;
  for (int i = kSamples; i >= 0; --i) {
    const double x = static_cast<double>(i) / kSamples;
    const double share = shape(x);
    if (!curve.knots.empty() && share <= curve.knots.back().x) continue;
    curve.knots.push_back({share, 1.0 - x});
  }
  return geom::CurveTable(geom::CurveFunction(curve, geom::CurveKind::linear), 0.0, 1.0, 4 * kSamples + 1);
}

/// A broad displacement by noise.
class Bend {
 public:
  Bend(double radius_m, double unevenness, double cell_m, Seed seed)
      : noise_{.wavelength_m = std::max(1e-3, 1.1 * radius_m), .octaves = 3, .gain = 0.5, .cell_m = cell_m},
        amount_m_(static_cast<float>(kBend * unevenness * radius_m)),
        east_(seed.derive("island.bend", 0)),
        north_(seed.derive("island.bend", 1)) {}

  void row(double x0, double dx, double y, std::span<float> east, std::span<float> north) const {
    std::fill(east.begin(), east.end(), 0.0F);
    std::fill(north.begin(), north.end(), 0.0F);
    if (amount_m_ <= 0.0F) return;
    geom::fbm_add_row(east_, noise_, x0, dx, y, east, amount_m_);
    geom::fbm_add_row(north_, noise_, x0, dx, y, north, amount_m_);
  }

  Vec2 at(Vec2 place) const {
    float east = 0.0F, north = 0.0F;
    row(place.x, noise_.cell_m, place.y, {&east, 1}, {&north, 1});
    return {static_cast<double>(east), static_cast<double>(north)};
  }

 private:
  static constexpr double kBend = 0.55;  ///< of the radius, times the noise
  geom::Fbm noise_;
  float amount_m_;
  Seed east_, north_;
};

float fourth(float v) { return v * v * v * v; }

float share_at(const Cone& cone, Vec2 p, float distance) {
  const double away = std::hypot(p.x - cone.place.x, p.y - cone.place.y);
  return cone.share * cone.profile(static_cast<float>(away / std::max(1e-9, away + static_cast<double>(distance))));
}

/// Lowers what each cone brings itself by what the others lift its place, so that the highest stays 1.
void settle(std::vector<Cone>& cones) {
  constexpr int kRounds = 6;
  std::vector<float> wanted;
  wanted.reserve(cones.size());
  for (const Cone& cone : cones) wanted.push_back(cone.share);
  for (int round = 0; round < kRounds; ++round) {
    for (size_t i = 0; i < cones.size(); ++i) {
      float others = 0.0F;
      for (size_t j = 0; j < cones.size(); ++j)
        others += j == i ? 0.0F : fourth(share_at(cones[j], cones[i].place, cones[i].distance));
      cones[i].share = std::pow(std::max(0.0F, fourth(wanted[i]) - others), 0.25F);
    }
  }
}

/// x around a summit; (x0, y): from it to the row's first node. What bends its slopes is counted from the bend at it.
SEAMOUNT_VECTORISED void coordinate_loop(const float* __restrict distance, const float* __restrict bend_x,
                                         const float* __restrict bend_y, float x0, float dx, float y, int count,
                                         float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    const float east = x0 + static_cast<float>(i) * dx + bend_x[i];
    const float north = y + bend_y[i];
    const float away = std::sqrt(east * east + north * north);
    const float depth = distance[i] < 0.0F ? -distance[i] : 0.0F;
    out[i] = away / (away + depth + 1e-9F);
  }
}

SEAMOUNT_VECTORISED void add_fourth(const float* __restrict share, float scale, int count, float* __restrict sum) {
  for (int i = 0; i < count; ++i) {
    const float s = scale * share[i];
    sum[i] += s * s * s * s;
  }
}

SEAMOUNT_VECTORISED void fourth_root(int count, float* __restrict sum) {
  for (int i = 0; i < count; ++i) sum[i] = std::sqrt(std::sqrt(sum[i]));
}

bool on_land(const std::vector<Polygon>& land, Vec2 place) {
  return std::any_of(land.begin(), land.end(), [&](const Polygon& polygon) { return geom::contains(polygon, place); });
}

/// How far a place lies from the land's border.
double depth_in(const std::vector<Polygon>& land, Vec2 place) {
  double least = 1e300;
  const auto include = [&](Ring ring) {
    ring.push_back(ring.front());
    least = std::min(least, geom::closest_on_polyline(ring, place).distance);
  };
  for (const Polygon& polygon : land) {
    include(polygon.outer);
    for (const Ring& hole : polygon.holes) include(hole);
  }
  return least;
}

}  // namespace

std::vector<Peak> choose_peaks(const Plan& plan, const std::vector<Summit>& given, std::optional<double> peak_m) {
  std::vector<Peak> peaks;
  for (size_t i = 0; i < given.size(); ++i) {
    const Summit& summit = given[i];
    if (!on_land(land_of(plan), summit.place))
      throw InvalidArgument(fmt::format("summits[{}].place", i),
                            fmt::format("({:.0f}, {:.0f}) does not lie on the land", summit.place.x, summit.place.y));
    double radius = depth_in(land_of(plan), summit.place);
    for (const Lobe& lobe : plan.lobes) {
      const Vec2 d = summit.place - lobe.centre;
      if (std::sqrt(dot(d, d)) < lobe.radius_m) radius = std::max(radius, lobe.radius_m);
    }
    peaks.push_back({summit.place, radius, summit.height_m.value_or(natural_height(2 * radius)), true,
                     summit.height_m.has_value(), summit.profile});
  }
  const double highest = plan.lobes.empty() ? 0.0 : natural_height(2 * plan.lobes.front().radius_m);
  const double scale = peak_m && highest > 0.0 ? *peak_m / highest : 1.0;
  for (const Lobe& lobe : plan.lobes) {
    const bool taken = std::any_of(given.begin(), given.end(), [&](const Summit& summit) {
      const Vec2 d = summit.place - lobe.centre;
      return dot(d, d) < lobe.radius_m * lobe.radius_m;
    });
    if (!taken) peaks.push_back({lobe.centre, lobe.radius_m, scale * natural_height(2 * lobe.radius_m)});
  }
  std::stable_sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.height_m > b.height_m; });
  return peaks;
}

double highest_at(const geom::CurveFunction& profile) {
  constexpr int kSteps = 200;
  double best = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double x = static_cast<double>(i) / kSteps;
    if (profile(x) > profile(best)) best = x;
  }
  return best;
}

void add_side_peaks(double massif, Seed seed, std::vector<Peak>& peaks) {
  constexpr double kLarge = 0.35;  // of the largest lobe's radius
  const auto each = static_cast<int>(std::lround(3.0 * massif));
  const std::vector<Peak> main = peaks;
  double largest = 0.0;
  for (const Peak& peak : main) largest = std::max(largest, peak.radius_m);
  for (size_t i = 0; i < main.size(); ++i) {
    const Peak& peak = main[i];
    if (peak.placed || peak.radius_m < kLarge * largest) continue;
    Rng rng(seed.derive("island.side_peaks", i));
    double bearing = rng.uniform(0.0, 2.0 * std::numbers::pi);
    for (int k = 0; k < each; ++k) {
      const double away = peak.radius_m * rng.uniform(0.38, 0.65);
      const Vec2 place = peak.place + away * Vec2{std::cos(bearing), std::sin(bearing)};
      peaks.push_back({place, peak.radius_m - away, peak.height_m * rng.uniform(0.45, 0.85)});
      bearing += rng.uniform(1.3, 2.6);
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.height_m > b.height_m; });
}

ScalarField rise(const std::vector<Peak>& peaks, const ScalarField& distance, const geom::CurveFunction& shape,
                 double foot_m, double unevenness, Seed seed, const RunContext& run) {
  const GridFrame& frame = distance.frame();
  const geom::CurveTable common(shape, 0.0, 1.0, kSamples + 1);
  std::vector<Cone> cones;
  const Bend bend(peaks.empty() ? 0.0 : peaks.front().radius_m, unevenness, frame.cell_m, seed);
  const double highest = peaks.empty() ? 1.0 : std::max(1e-6, peaks.front().height_m - foot_m);
  for (const Peak& peak : peaks) {
    const float at = geom::sample_bilinear(distance, frame.column(peak.place.x), frame.row(peak.place.y));
    cones.push_back({peak.place, static_cast<float>(std::max(0.0, peak.height_m - foot_m) / highest),
                     std::max(0.0F, -at), bend.at(peak.place),
                     peak.profile.knots.empty() ? common : normalised(peak.profile)});
  }
  settle(cones);
  const geom::CurveTable to_v = inverse(shape);
  ScalarField out(frame, 0.0F);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> share(static_cast<size_t>(frame.width)), bend_x(share.size()), bend_y(share.size());
    for (int y = begin; y < end; ++y) {
      const auto depth = distance.row(y);
      int first = 0, last = frame.width;
      while (first < last && depth[static_cast<size_t>(first)] >= 0.0F) ++first;
      while (last > first && depth[static_cast<size_t>(last - 1)] >= 0.0F) --last;
      const auto count = static_cast<size_t>(last - first);
      if (count == 0) continue;
      const std::span<float> sum = out.row(y).subspan(static_cast<size_t>(first), count);
      const std::span<float> own(share.data(), count);
      bend.row(frame.x(first), frame.cell_m, frame.y(y), {bend_x.data(), count}, {bend_y.data(), count});
      for (const Cone& cone : cones) {
        if (cone.share <= 0.0F) continue;
        const Vec2 from = Vec2{frame.x(first), frame.y(y)} - cone.place - cone.bend;
        coordinate_loop(&depth[static_cast<size_t>(first)], bend_x.data(), bend_y.data(), static_cast<float>(from.x),
                        static_cast<float>(frame.cell_m), static_cast<float>(from.y), static_cast<int>(count),
                        own.data());
        cone.profile.evaluate(own, own);
        add_fourth(own.data(), cone.share, static_cast<int>(count), sum.data());
      }
      fourth_root(static_cast<int>(count), sum.data());
      to_v.evaluate(sum, sum);
    }
  });
  return out;
}

}  // namespace seamount::island

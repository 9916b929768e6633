#include "seamount/ops/reef/surface.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/simd.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::reef {
namespace {

constexpr float kSoft = 1.0F;  // 1 / m: lifts approach the surface within about half a metre
constexpr int kSamples = 4096;
constexpr double kGrooveWavelength_m = 28.0;

struct Law {
  float w0, datum, w1, w2;
  float lift_m, rim_m, flat_m, crest_m, lagoon_m, fill, relief_m, lee_rim, cay_m, radius_m, k1, k1_jitter;
};

Law make_law(const SurfaceParams& p) {
  const auto f = [](double v) { return static_cast<float>(v); };
  const HeightParams& h = p.heights;
  return {f(h.w0),
          f(h.datum_m),
          f(h.w1),
          f(h.w2),
          f(h.lift_m),
          f(h.rim_m),
          f(h.flat_m),
          f(h.crest_m),
          f(p.sand.lagoon_m),
          f(p.sand.fill),
          f(p.detail.relief_m),
          f(h.lee_rim),
          f(p.sand.cay_m),
          f(p.radius_m),
          f(p.kernel.k1),
          f(p.kernel.k1_jitter)};
}

/// What a lift adds below a ceiling: smoothly the smaller of both, never negative.
SEAMOUNT_INLINE float saturated(float lift, float room) {
  const float least = geom::smin(lift, room, kSoft);
  return least > 0.0F ? least : 0.0F;
}

/// N and E of the union over t = 1 - D / R (grow.h).
SEAMOUNT_VECTORISED void union_lifts(const Law law, const geom::CurveTable& normal, const geom::CurveTable& edge,
                                     const float* distance, const float* noise, int count, float* out_normal,
                                     float* out_edge) {
  for (int i = 0; i < count; ++i) {
    const float depth = distance[i] / law.radius_m;
    const float t = 1.0F - depth;
    out_normal[i] = normal(t > 0.0F ? t : 0.0F);
    const float jitter = 1.0F + 2.0F * law.k1_jitter * noise[i];
    out_edge[i] = edge(law.k1 * (jitter > 0.2F ? jitter : 0.2F) * depth);
  }
}

/// P4 eq. 1 and 2 with h0 = base - datum.
SEAMOUNT_VECTORISED void proportional(const Law law, const float* base, const float* normal, const float* edge,
                                      int count, float* out) {
  for (int i = 0; i < count; ++i) {
    const float h0 = base[i] - law.datum;
    out[i] = law.datum + law.w0 * h0 + law.w1 * h0 * normal[i] + law.w2 * h0 * edge[i];
  }
}

/// Share of the way to the lagoon's floor that sand fills, by how crowded the reef is.
SEAMOUNT_INLINE float sand_share(float crowding) { return geom::smoothstep((crowding - 0.04F) * 2.4F); }

SEAMOUNT_VECTORISED void saturating(const Law law, const float* base, const float* distance, const float* crowding,
                                    const float* exposure, const float* cay, const float* normal, const float* edge,
                                    const float* relief, int count, float* out) {
  for (int i = 0; i < count; ++i) {
    const float z0 = law.datum + law.w0 * (base[i] - law.datum);
    const float crowd = crowding[i], rough = relief[i];
    const float windward = geom::smoothstep(0.5F + 0.8F * exposure[i]);
    // Sand between reefs, with patch reefs where the noise is high.
    const float knolls = rough > 0.3F ? 5.0F * (rough - 0.3F) : 0.0F;
    const float floor = law.lagoon_m + law.relief_m * (2.0F * rough + knolls);
    float z = z0 + law.fill * sand_share(crowd) * (floor > z0 ? floor - z0 : 0.0F);
    // The flat sinks to a lagoon far behind the rim, sooner in the lee.
    const float behind = (distance[i] / law.radius_m - 0.55F - 0.5F * windward) * 0.7F;
    const float deep = geom::smoothstep(behind + 0.5F * rough);
    const float flat = law.flat_m + law.relief_m * (0.8F * rough - 0.9F * (1.0F - windward)) +
                       deep * (law.lagoon_m + law.relief_m * knolls - law.flat_m);
    z += saturated(law.w1 * law.lift_m * normal[i], flat - z);
    const float rim = law.w2 * law.rim_m * (law.lee_rim + (1.0F - law.lee_rim) * windward) * edge[i];
    z += saturated(rim, law.crest_m + 0.4F * law.relief_m * (rough < 0.0F ? rough : 0.0F) - z);
    const float sand = law.cay_m * cay[i] + law.flat_m * (1.0F - cay[i]) + 0.5F * rough * cay[i];
    z += cay[i] * (sand > z ? sand - z : 0.0F);
    out[i] = z;
  }
}

}  // namespace

KernelTables::KernelTables(const KernelParams& params)
    : normal(
          make_table([k = params.k](double t) { return normal_kernel(t, k); }, 0.0, normal_reach(params.k), kSamples)),
      edge(make_table([k2 = params.k2](double s) { return s > 0.0 ? edge_kernel(0.0, s, k2) : 0.0; }, 0.0,
                      std::exp(std::pow(14.0, 1.0 / params.k2)), kSamples)) {}

SurfaceRows::SurfaceRows(const Form& form, const SurfaceParams& params, const GridFrame& frame, Seed seed)
    : form_(form),
      params_(params),
      frame_(frame),
      seed_(seed),
      fine_{.wavelength_m = 0.6 * params.radius_m, .octaves = 6, .gain = 0.55, .cell_m = frame.cell_m},
      relief_{.wavelength_m = 1.6 * params.radius_m, .octaves = 7, .gain = 0.6, .cell_m = frame.cell_m},
      distance_rows_(form.distance),
      crowding_rows_(form.crowding),
      exposure_rows_(form.exposure),
      cay_rows_(form.cays.empty() ? form.distance : form.cays),
      above_rows_(form.distance),
      below_rows_(form.distance) {
  const auto width = static_cast<size_t>(frame.width);
  for (auto* row : {&distance_, &crowding_, &exposure_, &cay_, &above_, &below_, &fine_noise_, &relief_noise_,
                    &normal_lift_, &edge_lift_})
    row->assign(width, 0.0F);
}

/// N and E of a row; false where the row lies far from any reef.
bool SurfaceRows::read_lifts(int y) {
  const double x0 = frame_.x(0), dx = frame_.cell_m, place = frame_.y(y);
  if (form_.sums) {
    form_.sums->row(x0, dx, place, normal_lift_, edge_lift_);
    if (params_.heights.mode == Lift::proportional) return true;
  }
  distance_rows_.read(x0, dx, place, distance_);
  const float nearest = *std::max_element(distance_.begin(), distance_.end());
  crowding_rows_.read(x0, dx, place, crowding_);
  const float crowd = *std::max_element(crowding_.begin(), crowding_.end());
  if (!form_.sums) {
    if (nearest < -params_.radius_m * normal_reach(params_.kernel.k) && crowd <= 0.0F) return false;
    if (params_.irregularity > 0) {
      geom::fbm_row(seed_.derive("reef.fine"), fine_, x0, dx, place, fine_noise_);
      const auto scale = static_cast<float>(0.12 * params_.radius_m * params_.irregularity);
      for (size_t i = 0; i < distance_.size(); ++i) distance_[i] += scale * fine_noise_[i];
    }
    if (params_.detail.grooves_m > 0) add_grooves(y);
    union_lifts(make_law(params_), form_.tables->normal, form_.tables->edge, distance_.data(), fine_noise_.data(),
                frame_.width, normal_lift_.data(), edge_lift_.data());
  }
  return true;
}

/// Spurs and grooves run straight down the fore reef: noise at the foot of the perpendicular on the outline pushes the
/// edge in and out. Only where cells can carry them.
void SurfaceRows::add_grooves(int y) {
  const double weight = geom::octave_weight(kGrooveWavelength_m, frame_.cell_m);
  if (weight <= 0) return;
  const double x0 = frame_.x(0), dx = frame_.cell_m, place = frame_.y(y), h = form_.distance.cell_m();
  const auto width = distance_.size();
  above_rows_.read(x0, dx, place + h, above_);
  below_rows_.read(x0, dx, place - h, below_);
  const auto deep = static_cast<float>(-0.5 * params_.radius_m), shallow = static_cast<float>(0.25 * params_.radius_m);
  const auto span = std::max<size_t>(1, static_cast<size_t>(h / dx));
  const Seed noise = seed_.derive("reef.grooves");
  std::vector<float> plain = distance_;
  for (size_t i = 0; i < width; ++i) {
    const float d = plain[i];
    if (d <= deep || d >= shallow) continue;
    const size_t a = i >= span ? i - span : 0, b = std::min(width - 1, i + span);
    const double gx = (plain[b] - plain[a]) / (static_cast<double>(b - a + (a == b ? 1 : 0)) * dx);
    const double gy = (above_[i] - below_[i]) / (2.0 * h);
    const double square = std::max(gx * gx + gy * gy, 0.25);
    const double px = x0 + static_cast<double>(i) * dx - d * gx / square, py = place - d * gy / square;
    const double n = geom::perlin(noise, px / kGrooveWavelength_m, py / kGrooveWavelength_m);
    const double along = static_cast<double>(d > 0 ? 1.0F - d / shallow : 1.0F - d / deep);
    const double windward = geom::smoothstep(0.5 + 0.8 * static_cast<double>(exposure_[i]));
    distance_[i] += static_cast<float>(6.0 * params_.detail.grooves_m * weight * along * windward * n);
  }
}

void SurfaceRows::row(int y, std::span<const float> base, std::span<float> height, std::span<float> aggregate) {
  const double x0 = frame_.x(0), dx = frame_.cell_m, place = frame_.y(y);
  const Law law = make_law(params_);
  const bool rising = params_.heights.mode == Lift::saturating;
  if (rising && params_.detail.grooves_m > 0) exposure_rows_.read(x0, dx, place, exposure_);
  const bool near = read_lifts(y);
  if (!near) {
    std::fill(normal_lift_.begin(), normal_lift_.end(), 0.0F);
    std::fill(edge_lift_.begin(), edge_lift_.end(), 0.0F);
  }
  for (size_t i = 0; i < aggregate.size(); ++i) aggregate[i] = std::min(1.0F, normal_lift_[i]);
  if (!rising || !near) {
    proportional(law, base.data(), normal_lift_.data(), edge_lift_.data(), frame_.width, height.data());
    return;
  }
  exposure_rows_.read(x0, dx, place, exposure_);
  if (!form_.cays.empty()) cay_rows_.read(x0, dx, place, cay_);
  if (params_.detail.relief_m > 0) geom::fbm_row(seed_.derive("reef.relief"), relief_, x0, dx, place, relief_noise_);
  saturating(law, base.data(), distance_.data(), crowding_.data(), exposure_.data(), cay_.data(), normal_lift_.data(),
             edge_lift_.data(), relief_noise_.data(), frame_.width, height.data());
}

}  // namespace seamount::reef

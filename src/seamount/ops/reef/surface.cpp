#include "seamount/ops/reef/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/simd.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::reef {
namespace {

constexpr float kSoft = 1.0F;  // 1 / m: lifts approach the surface within about half a metre
constexpr int kSamples = 4096;
constexpr float kNoPass_m = 1e9F;  // above all ground

struct Law {
  float w0, datum, w1, w2;
  float lift_m, rim_m, flat_m, crest_m, lagoon_m, fill, relief_m, lee_rim, cay_m, radius_m, k1, k1_jitter;
  float fore_slope, lee_slope, shoulder_m;
  float dark_m, light_m, lightless_m;  ///< ground at which growth ends, is full, and at which sand ends
};

Law make_law(const SurfaceParams& p) {
  const auto f = [](double v) { return static_cast<float>(v); };
  const auto slope = [&](double degrees) { return f(std::tan(degrees * std::numbers::pi / 180.0)); };
  const HeightParams& h = p.heights;
  const float span = std::max(1.0F, 0.25F * std::abs(f(p.low_m)));
  Law law{};
  law.w0 = f(h.w0), law.datum = f(h.datum_m), law.w1 = f(h.w1), law.w2 = f(h.w2);
  law.lift_m = f(h.lift_m), law.rim_m = f(h.rim_m), law.flat_m = f(h.flat_m), law.crest_m = f(h.crest_m);
  law.lagoon_m = f(p.sand.lagoon_m), law.fill = f(p.sand.fill), law.relief_m = f(p.detail.relief_m);
  law.lee_rim = f(h.lee_rim), law.cay_m = f(p.sand.cay_m), law.radius_m = f(p.radius_m);
  law.k1 = f(p.kernel.k1), law.k1_jitter = f(p.kernel.k1_jitter);
  law.fore_slope = slope(h.fore_slope_deg), law.lee_slope = slope(h.lee_slope_deg);
  law.shoulder_m = law.radius_m / law.k1;
  law.dark_m = f(p.low_m) - 0.6F * span, law.light_m = f(p.low_m) + 0.4F * span;
  law.lightless_m = f(p.low_m) - 4.0F * span;
  return law;
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

/// Share of the way to the lagoon's floor that sand fills: by how crowded the reef is, and hardly before a reef to
/// windward, from where waves carry it across.
SEAMOUNT_INLINE float sand_share(float crowding, float windward) {
  const float sheltered = geom::smoothstep((crowding - 0.35F) * 4.0F);
  return geom::smoothstep((crowding - 0.04F) * 2.4F) * (1.0F - 0.9F * windward * (1.0F - sheltered));
}

SEAMOUNT_INLINE float positive(float x) { return x > 0.0F ? x : 0.0F; }

/// 0 where the ground is land or too deep for light, 1 between.
SEAMOUNT_INLINE float light_on(float z, float dark, float light) {
  const float wet = -2.0F * z;
  const float under = wet < 1.0F ? wet : 1.0F;
  return positive(under) * geom::smoothstep((z - dark) / (light - dark));
}

/// Metres by which the side of a reef has fallen, x metres outside the edge of its flat: a round shoulder, then a
/// slope.
SEAMOUNT_INLINE float fall(float x, float slope, float shoulder) {
  const float out = positive(x);
  return slope * out * out / (out + shoulder);
}

/// Rows that saturating() reads, of one length.
struct Rows {
  const float *base, *distance, *crowding, *exposure, *lagoon, *knoll, *cay, *pass, *normal, *edge, *relief;
};

/// The ground of a reef and its share of it (grow.h). `sloping` is 1 where sides fall with a slope, 0 where N of P4's
/// summed kernels shapes them.
SEAMOUNT_VECTORISED void saturating(const Law law, const Rows rows, float sloping, int count, float* __restrict out,
                                    float* __restrict aggregate) {
  for (int i = 0; i < count; ++i) {
    const float base = rows.base[i], normal = rows.normal[i], edge = rows.edge[i], pass = rows.pass[i];
    const float rough = rows.relief[i], crowd = rows.crowding[i], in_lagoon = rows.lagoon[i];
    const float knoll_share = rows.knoll[i], cay_share = rows.cay[i], distance = rows.distance[i];
    const float z0 = base + (law.w0 - 1.0F) * (base - law.datum);
    const float windward = geom::smoothstep(0.5F + 0.8F * rows.exposure[i]);
    const float light = light_on(z0, law.dark_m, law.light_m);
    const float sandy = light_on(z0, law.lightless_m, law.dark_m);
    const float floor = law.lagoon_m + 2.0F * law.relief_m * rough;
    float z = z0 + law.fill * sandy * sand_share(crowd, windward) * positive(floor - z0);
    // The flat gives way to the slope of the back reef, then to the lagoon.
    const float back = geom::smoothstep(in_lagoon * (1.0F / 90.0F) + 0.5F * rough);
    const float deep = back * (0.6F + 0.4F * geom::smoothstep(in_lagoon * (1.0F / 500.0F)));
    const float flat = law.flat_m + law.relief_m * (0.8F * rough - 0.9F * (1.0F - windward));
    const float slope = law.lee_slope + windward * (law.fore_slope - law.lee_slope);
    const float outside = law.shoulder_m - distance;
    const float top = flat + deep * (floor - flat) - sloping * fall(outside, slope, law.shoulder_m);
    const float reach = sloping + (1.0F - sloping) * normal;
    const float room = top - z;
    const float lift = saturated(law.w1 * law.lift_m * light * reach, room);
    const float share = lift / (flat - z0 > 2.0F ? flat - z0 : 2.0F);
    z += lift;
    // Rims stand where waves come in, not around holes in the thick of a reef.
    const float open = 1.0F - geom::smoothstep((crowd - 0.55F) * 5.0F);
    const float rim = law.w2 * law.rim_m * light * (law.lee_rim + (1.0F - law.lee_rim) * windward) * edge;
    z += saturated(open * rim, law.crest_m + 0.4F * law.relief_m * (rough < 0.0F ? rough : 0.0F) - z);
    z += light * positive(knoll_share) * positive(law.flat_m - 1.0F - z);
    const float heap = light * positive(cay_share);
    const float cay = heap + 0.35F * rough * heap * positive(1.0F - heap);
    const float sand = law.cay_m * cay + law.flat_m * (1.0F - cay) + 0.5F * rough * cay;
    z += geom::smoothstep(3.0F * cay) * positive(sand - z);
    const float channel = pass > 0.0F ? -pass * (1.0F + 0.2F * rough) : kNoPass_m;
    const float bed = channel > z0 ? channel : z0;
    out[i] = bed < z ? bed : z;
    const float dug = geom::smoothstep((pass - 2.5F) * 0.25F);
    const float kept = bed < z ? 1.0F - dug : 1.0F;
    const float on_reef = light * normal, of_side = sloping * geom::smoothstep(1.25F * share);
    const float most = on_reef > of_side ? on_reef : of_side;
    const float on = kept * (most < 1.0F ? most : 1.0F);
    aggregate[i] = positive(on);  // none on unknown ground (NaN)
  }
}

}  // namespace

KernelTables::KernelTables(const KernelParams& params)
    : normal(
          make_table([k = params.k](double t) { return normal_kernel(t, k); }, 0.0, normal_reach(params.k), kSamples)),
      edge(make_table([k2 = params.k2](double s) { return s > 0.0 ? edge_kernel(0.0, s, k2) : 0.0; }, 0.0,
                      std::exp(std::pow(14.0, 1.0 / params.k2)), kSamples)) {}

Layer::Layer(ScalarField values, float without) : field(std::move(values)), none(without) {
  for (int y = 0; y < field.height(); ++y) {
    const auto row = field.row(y);
    rows.push_back(std::any_of(row.begin(), row.end(), [&](float v) { return v > none; }) ? 1 : 0);
  }
}

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
      lagoon_rows_(form.lagoon.field.empty() ? form.distance : form.lagoon.field),
      knoll_rows_(form.knolls.field.empty() ? form.distance : form.knolls.field),
      cay_rows_(form.cays.field.empty() ? form.distance : form.cays.field),
      pass_rows_(form.passes.field.empty() ? form.distance : form.passes.field),
      above_rows_(form.distance),
      below_rows_(form.distance) {
  const auto width = static_cast<size_t>(frame.width);
  for (auto* row : {&distance_, &crowding_, &exposure_, &lagoon_, &knoll_, &cay_, &pass_, &above_, &below_,
                    &fine_noise_, &relief_noise_, &normal_lift_, &edge_lift_})
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
    const Law law = make_law(params_);
    const float reach = std::max(law.radius_m * static_cast<float>(normal_reach(params_.kernel.k)),
                                 law.lift_m / std::min(law.fore_slope, law.lee_slope) + 2.0F * law.shoulder_m);
    if (nearest < -reach && crowd <= 0.0F) return false;
    if (params_.irregularity > 0) {
      geom::fbm_row(seed_.derive("reef.fine"), fine_, x0, dx, place, fine_noise_);
      const auto scale = static_cast<float>(0.12 * params_.radius_m * params_.irregularity);
      for (size_t i = 0; i < distance_.size(); ++i) distance_[i] += scale * fine_noise_[i];
    }
    if (params_.detail.grooves_m > 0) add_grooves(y);
    union_lifts(law, form_.tables->normal, form_.tables->edge, distance_.data(), fine_noise_.data(), frame_.width,
                normal_lift_.data(), edge_lift_.data());
  }
  return true;
}

/// Spurs and grooves run straight down the fore reef: noise at the foot of the perpendicular on the outline pushes the
/// edge in and out. Only where cells can carry them.
void SurfaceRows::add_grooves(int y) {
  const double spacing = params_.detail.groove_spacing_m, weight = geom::octave_weight(spacing, frame_.cell_m);
  if (weight <= 0) return;
  const double x0 = frame_.x(0), dx = frame_.cell_m, place = frame_.y(y), h = form_.distance.cell_m();
  const auto width = distance_.size();
  above_rows_.read(x0, dx, place + h, above_);
  below_rows_.read(x0, dx, place - h, below_);
  const double slope = std::tan(params_.heights.fore_slope_deg * std::numbers::pi / 180.0);
  const auto deep = static_cast<float>(-25.0 / slope - 20.0), shallow = static_cast<float>(0.3 * params_.radius_m);
  const auto span = std::max<size_t>(1, static_cast<size_t>(h / dx));
  const Seed noise = seed_.derive("reef.grooves");
  const double wavelength = spacing / 1.7;  // peaks of gradient noise lie about 1.7 of its wavelengths apart
  std::vector<float> plain = distance_;
  for (size_t i = 0; i < width; ++i) {
    const float d = plain[i];
    if (d <= deep || d >= shallow) continue;
    const double windward = geom::smoothstep(0.4 + 1.2 * static_cast<double>(exposure_[i]));
    if (windward <= 0) continue;
    const size_t a = i >= span ? i - span : 0, b = std::min(width - 1, i + span);
    const double gx = (plain[b] - plain[a]) / (static_cast<double>(b - a + (a == b ? 1 : 0)) * dx);
    const double gy = (above_[i] - below_[i]) / (2.0 * h);
    const double square = std::max(gx * gx + gy * gy, 0.25);
    const double px = x0 + static_cast<double>(i) * dx - d * gx / square, py = place - d * gy / square;
    const double n = geom::perlin(noise, px / wavelength, py / wavelength);
    const double along = static_cast<double>(d > 0 ? 1.0F - d / shallow : 1.0F - d / deep);
    distance_[i] += static_cast<float>(1.6 * params_.detail.grooves_m / slope * weight * along * windward * n);
  }
}

void SurfaceRows::read_layer(const Layer& layer, geom::RowUpsampler& rows, double place,
                             std::vector<float>& out) const {
  const int row = static_cast<int>(layer.field.empty() ? 0.0 : layer.field.frame().row(place));
  const int first = std::max(0, row - 1), last = std::min(static_cast<int>(layer.rows.size()) - 1, row + 2);
  for (int y = first; y <= last; ++y) {
    if (layer.rows[static_cast<size_t>(y)] == 0) continue;
    rows.read(frame_.x(0), frame_.cell_m, place, out);
    return;
  }
  std::fill(out.begin(), out.end(), layer.none);
}

/// Reads what only rising reefs have.
void SurfaceRows::read_form(double place) {
  const double x0 = frame_.x(0), dx = frame_.cell_m;
  if (params_.detail.grooves_m <= 0) exposure_rows_.read(x0, dx, place, exposure_);
  read_layer(form_.lagoon, lagoon_rows_, place, lagoon_);
  read_layer(form_.knolls, knoll_rows_, place, knoll_);
  read_layer(form_.cays, cay_rows_, place, cay_);
  read_layer(form_.passes, pass_rows_, place, pass_);
  if (params_.detail.relief_m > 0) geom::fbm_row(seed_.derive("reef.relief"), relief_, x0, dx, place, relief_noise_);
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
  if (!rising || !near) {
    for (size_t i = 0; i < aggregate.size(); ++i) aggregate[i] = std::min(1.0F, normal_lift_[i]);
    proportional(law, base.data(), normal_lift_.data(), edge_lift_.data(), frame_.width, height.data());
    if (rising && law.w0 == 1.0F) std::copy(base.begin(), base.end(), height.begin());
    return;
  }
  read_form(place);
  const Rows rows{base.data(),         distance_.data(),  crowding_.data(),    exposure_.data(),
                  lagoon_.data(),      knoll_.data(),     cay_.data(),         pass_.data(),
                  normal_lift_.data(), edge_lift_.data(), relief_noise_.data()};
  saturating(law, rows, form_.sums ? 0.0F : 1.0F, frame_.width, height.data(), aggregate.data());
}

}  // namespace seamount::reef

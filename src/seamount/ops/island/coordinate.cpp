#include "seamount/ops/island/coordinate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::island {
namespace {

constexpr int kAngles = 2048;
constexpr int kLatticeSide = 1024;
constexpr int kDomeSide = 256;  // the dome is smooth: its edge comes from the distance field
constexpr float kTurn = static_cast<float>(2.0 * std::numbers::pi);

SEAMOUNT_INLINE float clamp01(float v) { return v < 0.0F ? 0.0F : (v > 1.0F ? 1.0F : v); }

/// Angle of (x, y) in turns, [0, 1); polynomial of atan on [0, 1], error below 2e-6 turns.
SEAMOUNT_INLINE float turns(float x, float y) {
  const float ax = x < 0 ? -x : x;
  const float ay = y < 0 ? -y : y;
  const float high = ax > ay ? ax : ay;
  const float low = ax > ay ? ay : ax;
  const float q = low / (high > 1e-20F ? high : 1e-20F);
  const float s = q * q;
  float a = q * (0.99997726F +
                 s * (-0.33262347F + s * (0.19354346F + s * (-0.11643287F + s * (0.05265332F - s * 0.01172120F)))));
  a = ay > ax ? 1.57079633F - a : a;
  a = x < 0 ? 3.14159265F - a : a;
  a = y < 0 ? kTurn - a : a;
  const float t = a * (1.0F / kTurn);
  return t < 1.0F ? t : 0.0F;
}

constexpr int kChunk = 256;

/// A piece of a row in polar coordinates: distance, table index of the angle and the share of the way to the next.
struct PolarChunk {
  std::array<float, kChunk> r, share, inner, outer;
  std::array<int32_t, kChunk> index;
};

SEAMOUNT_VECTORISED void to_polar(float x0, float dx, float y, int count, PolarChunk& chunk) {
  for (int i = 0; i < count; ++i) {
    const float x = x0 + static_cast<float>(i) * dx;
    const float t = turns(x, y) * static_cast<float>(kAngles);
    const int32_t a = static_cast<int32_t>(t);
    chunk.index[i] = a;
    chunk.share[i] = t - static_cast<float>(a);
    chunk.r[i] = std::sqrt(x * x + y * y);
  }
}

SEAMOUNT_VECTORISED void read_radii(const float* __restrict table, const int32_t* __restrict index,
                                    const float* __restrict share, int count, float* __restrict outer) {
  for (int i = 0; i < count; ++i) {
    const float a = table[index[i]];
    outer[i] = a + share[i] * (table[index[i] + 1] - a);
  }
}

/// The summit stays where it is: detail fades in from the centre to the first outline.
SEAMOUNT_VECTORISED void first_share(const float* __restrict r, const float* __restrict outer,
                                     const float* __restrict shift, int count, float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    const float inverse = 1.0F / outer[i];
    out[i] = clamp01((r[i] + shift[i] * clamp01(r[i] * inverse)) * inverse);
  }
}

SEAMOUNT_VECTORISED void next_share(const float* __restrict r, const float* __restrict inner,
                                    const float* __restrict outer, const float* __restrict shift, int count,
                                    float* __restrict out) {
  for (int i = 0; i < count; ++i) out[i] += clamp01((r[i] + shift[i] - inner[i]) / (outer[i] - inner[i]));
}

/// Sum of clamped shares over the regions: i + (r - R_i) / (R_{i+1} - R_i) for the i with R_i <= r < R_{i+1} (eq. 1.1).
void polar_chunk(const std::vector<float>& radii, const float* shift, float x0, float dx, float y, int count,
                 float* out) {
  PolarChunk chunk;
  to_polar(x0, dx, y, count, chunk);
  for (int k = 0; k < kOutlineCount; ++k) {
    std::swap(chunk.inner, chunk.outer);
    read_radii(radii.data() + k * (kAngles + 1), chunk.index.data(), chunk.share.data(), count, chunk.outer.data());
    if (k == 0) {
      first_share(chunk.r.data(), chunk.outer.data(), shift, count, out);
    } else {
      next_share(chunk.r.data(), chunk.inner.data(), chunk.outer.data(), shift, count, out);
    }
  }
}

/// Adds the share of the region between two outlines.
SEAMOUNT_VECTORISED void add_share(const float* inner, float inner_offset, const float* outer, float outer_offset,
                                   const float* width, const float* shift, int count, float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    const float d_in = inner[i] - inner_offset * width[i] + shift[i];
    const float d_out = outer[i] - outer_offset * width[i] + shift[i];
    const float span = d_in - d_out;
    out[i] += clamp01(d_in / (span > 1e-3F ? span : 1e-3F));
  }
}

/// x~ inside the innermost outline: 1 - v. v itself is read in the interior, and near the outline its slope times the
/// depth inside it, which is exact there.
SEAMOUNT_VECTORISED void dome_loop(const float* field, float offset, const float* v, const float* slope,
                                   const float* width, const float* shift, float rim, float base, int count,
                                   float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    const float inside = offset * width[i] - field[i] - shift[i];
    const float depth = inside > 0.0F ? inside : 0.0F;
    const float t = geom::smoothstep(depth / rim);
    const float near_rim = slope[i] * depth;
    out[i] = base + clamp01(1.0F - (near_rim + t * (v[i] - near_rim)));
  }
}

/// Softens the creases of a distance field: at distance d it becomes the field blurred by 0.45 smoothing d, between the
/// nearest of a few blurs; unchanged at the outline itself.
void soften(ScalarField& distance, double smoothing, const RunContext& run) {
  if (smoothing <= 0) return;
  constexpr double kReach = 0.45;
  constexpr double kStep = 2.2;
  const double largest = 0.2 * std::min(distance.frame().width_m(), distance.frame().height_m());
  const ScalarField sharp = distance;
  ScalarField finer = distance;
  double finer_sigma = 0;
  for (double sigma = 1.5 * distance.cell_m(); sigma < largest * kStep; sigma *= kStep) {
    ScalarField coarser = sharp;
    geom::gaussian_blur(coarser, sigma, run);
    parallel_rows(run, distance.width(), distance.height(), [&](int begin, int end) {
      for (int64_t i = static_cast<int64_t>(begin) * distance.width(); i < static_cast<int64_t>(end) * distance.width();
           ++i) {
        const auto c = static_cast<size_t>(i);
        const double wanted = std::min(kReach * smoothing * std::abs(sharp.cells()[c]), largest);
        if (wanted < finer_sigma) continue;
        const auto t = static_cast<float>(std::min(1.0, (wanted - finer_sigma) / (sigma - finer_sigma)));
        distance.cells()[c] = finer.cells()[c] + t * (coarser.cells()[c] - finer.cells()[c]);
      }
    });
    finer = std::move(coarser);
    finer_sigma = sigma;
  }
}

/// Factor of widths where noise says n, deviation about 0.35, and the coast bends by `headland`: out to sea above 0.
float width_factor(double variation, double n, double headland) {
  return static_cast<float>(std::exp(variation * std::clamp(1.5 * n - 2.0 * headland, -1.5, 1.5)));
}

/// Beaches, lagoons and reefs are wider in bays than off headlands, and uneven besides.
ScalarField width_factors(const ScalarField& coast, double reef_end_m, double slope_end_m, const Interior& interior,
                          const RunContext& run) {
  const double radius = interior.peaks.empty() ? 0.25 * coast.frame().width_m() : interior.peaks.front().radius_m;
  const double sigma = 0.2 * radius;
  ScalarField smooth = coast;
  geom::gaussian_blur(smooth, sigma, run);
  ScalarField out =
      geom::fbm_grid(coast.frame(), interior.seed.derive("island.widths"),
                     {.wavelength_m = std::max(1e-3, 0.9 * radius), .octaves = 3, .cell_m = coast.cell_m()}, run);
  for (size_t c = 0; c < out.size(); ++c) {
    const double bend = (smooth.cells()[c] - coast.cells()[c]) / std::max(1e-6, sigma) - 0.1;
    out.cells()[c] = width_factor(interior.width_variation, out.cells()[c], bend);
  }
  geom::gaussian_blur(out, 0.5 * sigma, run);
  for (size_t c = 0; c < out.size(); ++c) {  // the sea floor far out is even
    const double away = (coast.cells()[c] - reef_end_m) / std::max(1e-6, 0.7 * (slope_end_m - reef_end_m));
    out.cells()[c] = 1.0F + (out.cells()[c] - 1.0F) * static_cast<float>(geom::smoothstep(1.0 - away));
  }
  return out;
}

/// The same around a centre; empty: as they are.
std::vector<float> polar_width_factors(const std::vector<double>& coast, const Interior& interior) {
  if (interior.width_variation <= 0) return {};
  constexpr size_t kCoarse = 256;  // the factors are smooth
  const size_t step = coast.size() / kCoarse, reach = coast.size() / 24;
  std::vector<double> coarse(kCoarse);
  for (size_t k = 0; k < kCoarse; ++k) {
    double sum = 0.0;
    for (size_t a = 0; a <= 2 * reach; a += step) sum += coast[(k * step + a + coast.size() - reach) % coast.size()];
    const double mean = sum / (std::floor(2.0 * static_cast<double>(reach) / static_cast<double>(step)) + 1.0);
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / kCoarse;
    const double n = geom::fbm_circle(interior.seed.derive("island.widths"), angle, 4.0, 3);
    coarse[k] = width_factor(interior.width_variation, n, 4.0 * (coast[k * step] / mean - 1.0));
  }
  const std::vector<double> fine = resample_radii(coarse, static_cast<int>(coast.size()));
  return {fine.begin(), fine.end()};
}

/// One of equal height for every lobe.
std::vector<Peak> peaks_of_lobes(const Plan& plan) {
  std::vector<Peak> peaks;
  for (const Lobe& lobe : plan.lobes.empty() ? find_lobes(land_of(plan)) : plan.lobes)
    peaks.push_back({lobe.centre, lobe.radius_m, 1.0});
  return peaks;
}

/// v / depth where v is well inside, spread a little outwards, so that it can be read right up to the outline.
ScalarField slope_at_rim(const ScalarField& v, const ScalarField& distance, double offset, const RunContext& run) {
  const GridFrame& frame = v.frame();
  ScalarField slope(frame, 0.0F), weight(frame, 0.0F);
  for (size_t c = 0; c < v.size(); ++c) {
    const auto depth = static_cast<float>(offset - distance.cells()[c]);
    if (depth < 1.5F * static_cast<float>(frame.cell_m)) continue;
    weight.cells()[c] = 1.0F;
    slope.cells()[c] = v.cells()[c] / depth;
  }
  const ScalarField exact = slope;
  ScalarField cover = weight;
  geom::gaussian_blur(slope, 1.5 * frame.cell_m, run);
  geom::gaussian_blur(cover, 1.5 * frame.cell_m, run);
  for (size_t c = 0; c < v.size(); ++c) {
    const float spread = cover.cells()[c] > 1e-4F ? slope.cells()[c] / cover.cells()[c] : 0.0F;
    slope.cells()[c] = weight.cells()[c] > 0 ? exact.cells()[c] : spread;
  }
  return slope;
}

}  // namespace

RegionCoordinate::RegionCoordinate(const Plan& plan, const GridFrame& frame, double smoothing, const RunContext& run,
                                   const Interior& interior)
    : lattice_(geom::coarser_frame(frame, std::max(frame.width_m(), frame.height_m()) / kLatticeSide)),
      centre_(plan.centre) {
  if (plan.polar.empty()) {
    prepare_areas(plan, smoothing, interior, run);
  } else {
    prepare_polar(plan, interior);
  }
}

void RegionCoordinate::prepare_polar(const Plan& plan, const Interior& interior) {
  const std::vector<double> coast = resample_radii(plan.polar[kCoast].radii_m, kAngles);
  const std::vector<float> factors = plan.derived ? polar_width_factors(coast, interior) : std::vector<float>();
  for (const PolarOutline& outline : plan.polar) {
    std::vector<double> radii = resample_radii(outline.radii_m, kAngles);
    for (size_t a = 0; a < factors.size(); ++a)
      radii[a] = std::max(0.1 * coast[a], coast[a] + static_cast<double>(factors[a]) * (radii[a] - coast[a]));
    radii_.insert(radii_.end(), radii.begin(), radii.end());
    radii_.push_back(static_cast<float>(radii.front()));
  }
  // Resampling between given angles may bring neighbours together: keep a minimum gap (NOTES: ordered, never crossing).
  for (size_t a = 0; a <= kAngles; ++a) {
    float inner = 0.0F;
    for (size_t k = 0; k < kOutlineCount; ++k) {
      float& r = radii_[k * (kAngles + 1) + a];
      r = std::max(r, inner * 1.001F + 1e-3F);
      inner = r;
    }
  }
}

void RegionCoordinate::prepare_areas(const Plan& plan, double smoothing, const Interior& interior,
                                     const RunContext& run) {
  while (first_ < kCoast && plan.areas[first_].empty() && plan.areas[kCoast].empty()) ++first_;
  while (first_ + 1 < kOutlineCount && plan.areas[kCoast].empty() && plan.areas[first_].empty()) ++first_;
  const std::array<double, kOutlineCount> widths = {0, plan.widths.beach_m, plan.widths.lagoon_m, plan.widths.reef_m,
                                                    plan.widths.slope_m};
  std::array<int, kOutlineCount> field_of{};
  field_of.fill(-1);
  for (int i = first_; i < kOutlineCount; ++i) {
    if (plan.areas[i].empty()) continue;
    field_of[i] = static_cast<int>(fields_.size());
    fields_.push_back(geom::signed_distance(plan.areas[i], lattice_, run));
    soften(fields_.back(), smoothing, run);
  }
  for (int i = first_; i < kOutlineCount; ++i) {
    if (field_of[i] >= 0) {
      levels_.push_back({field_of[i], 0.0});
    } else if (i == 0) {
      levels_.push_back({field_of[kCoast], -plan.widths.beach_m});  // the mountains' foot, inside the coast
    } else {
      levels_.push_back({levels_.back().field, levels_.back().offset_m + widths[static_cast<size_t>(i)]});
    }
  }
  const double cell = std::max(2.0 * lattice_.cell_m, std::max(lattice_.width_m(), lattice_.height_m()) / kDomeSide);
  const double offset = levels_[0].offset_m;
  ScalarField depth =
      geom::resample(fields_[static_cast<size_t>(levels_[0].field)], geom::coarser_frame(lattice_, cell), run);
  const bool derived = levels_.size() > 1 && (offset != 0.0 || levels_.back().offset_m != 0.0);
  if (interior.width_variation > 0 && derived)
    widths_ = width_factors(depth, levels_[levels_.size() - 2].offset_m, levels_.back().offset_m, interior, run);
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x)
      depth(x, y) -= static_cast<float>(offset) * (widths_.empty() ? 1.0F : widths_(x, y));
  }
  dome_.v = rise(interior.peaks.empty() ? peaks_of_lobes(plan) : interior.peaks, depth, interior.shape, interior.foot_m,
                 interior.unevenness, interior.seed, run);
  dome_.slope = slope_at_rim(dome_.v, depth, 0.0, run);
}

void RegionCoordinate::row(double x0, double dx, double y, std::span<const float> shift_m, std::span<float> out) const {
  const std::vector<float> none(shift_m.empty() ? out.size() : 0, 0.0F);
  const std::span<const float> shift = shift_m.empty() ? std::span<const float>(none) : shift_m;
  if (radii_.empty()) {
    area_row(x0, dx, y, shift, out);
  } else {
    polar_row(x0, dx, y, shift, out);
  }
}

void RegionCoordinate::polar_row(double x0, double dx, double y, std::span<const float> shift_m,
                                 std::span<float> out) const {
  const auto count = static_cast<int>(out.size());
  for (int begin = 0; begin < count; begin += kChunk) {
    polar_chunk(radii_, shift_m.data() + begin, static_cast<float>(x0 + begin * dx - centre_.x), static_cast<float>(dx),
                static_cast<float>(y - centre_.y), std::min(kChunk, count - begin), out.data() + begin);
  }
}

void RegionCoordinate::area_row(double x0, double dx, double y, std::span<const float> shift_m,
                                std::span<float> out) const {
  const auto count = static_cast<int>(out.size());
  std::vector<std::vector<float>> rows(fields_.size(), std::vector<float>(out.size()));
  for (size_t f = 0; f < fields_.size(); ++f) geom::RowUpsampler(fields_[f]).read(x0, dx, y, rows[f]);
  std::vector<float> v(out.size()), slope(out.size()), width(out.size(), 1.0F);
  if (!widths_.empty()) geom::RowUpsampler(widths_).read(x0, dx, y, width);
  geom::RowUpsampler(dome_.v).read(x0, dx, y, v);
  geom::RowUpsampler(dome_.slope).read(x0, dx, y, slope);
  const auto field_row = [&](const Level& level) { return rows[static_cast<size_t>(level.field)].data(); };
  dome_loop(field_row(levels_[0]), static_cast<float>(levels_[0].offset_m), v.data(), slope.data(), width.data(),
            shift_m.data(), static_cast<float>(4.0 * dome_.v.cell_m()), static_cast<float>(first_), count, out.data());
  for (size_t k = 0; k + 1 < levels_.size(); ++k) {
    add_share(field_row(levels_[k]), static_cast<float>(levels_[k].offset_m), field_row(levels_[k + 1]),
              static_cast<float>(levels_[k + 1].offset_m), width.data(), shift_m.data(), count, out.data());
  }
}

ScalarField coordinate_from_labels(const LabelMap& labels, const RunContext& run) {
  const GridFrame& frame = labels.frame();
  ScalarField out(frame, static_cast<float>(kOutlineCount));
  const auto half_cell = static_cast<float>(0.5 * frame.cell_m);
  const auto distance_where = [&](auto belongs) {
    Grid<uint8_t> inside(frame);
    for (size_t c = 0; c < labels.size(); ++c) inside.cells()[c] = belongs(static_cast<int>(labels.cells()[c])) ? 1 : 0;
    return geom::distance_to(inside, run);
  };
  for (int region = 0; region < kRegionCount; ++region) {
    const auto is_region = [&](int label) { return label == region; };
    bool present = false;
    for (const Region label : labels.cells()) present = present || is_region(static_cast<int>(label));
    if (!present) continue;
    const ScalarField inner = distance_where([&](int label) { return label < region; });
    const ScalarField outer = distance_where([&](int label) { return label > region; });
    float deepest = 1e-6F;
    for (size_t c = 0; c < labels.size(); ++c) {
      if (is_region(static_cast<int>(labels.cells()[c])) && std::isfinite(outer.cells()[c]))
        deepest = std::max(deepest, outer.cells()[c]);
    }
    for (size_t c = 0; c < labels.size(); ++c) {
      if (!is_region(static_cast<int>(labels.cells()[c]))) continue;
      const float in = std::max(0.0F, inner.cells()[c] - half_cell);
      const float away = std::max(0.0F, outer.cells()[c] - half_cell);
      float share = 0.0F;
      if (std::isinf(in)) {
        share =
            std::isinf(away) ? 0.0F : 1.0F - away / deepest;  // nothing further in: the summit is where it is deepest
      } else if (std::isinf(away)) {
        share = 1.0F - std::exp(-in / (16.0F * static_cast<float>(frame.cell_m)));  // nothing further out
      } else {
        share = in + away > 0.0F ? in / (in + away) : 0.5F;
      }
      out.cells()[c] = static_cast<float>(region) + clamp01(share);
    }
  }
  return out;
}

}  // namespace seamount::island

#include "seamount/ops/terrain/blend.h"

#include <cmath>
#include <limits>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/model/same_size.h"

namespace seamount::terrain {
namespace {

/// What the first terrain would be with a weight of 1, into `out`.
SEAMOUNT_VECTORISED void operate_row(BlendMode mode, int count, const float* __restrict a, const float* __restrict b,
                                     float* __restrict out) {
  if (mode == BlendMode::max) {
    for (int i = 0; i < count; ++i) out[i] = a[i] > b[i] ? a[i] : b[i];
  } else if (mode == BlendMode::min) {
    for (int i = 0; i < count; ++i) out[i] = a[i] < b[i] ? a[i] : b[i];
  } else if (mode == BlendMode::add) {
    for (int i = 0; i < count; ++i) out[i] = a[i] + b[i];
  } else if (mode == BlendMode::subtract) {
    for (int i = 0; i < count; ++i) out[i] = a[i] - b[i];
  } else {
    for (int i = 0; i < count; ++i) out[i] = b[i];
  }
}

/// out = a + w (out - a). Written so that w = 0 gives a and w = 1 gives out, exactly.
SEAMOUNT_VECTORISED void weigh_row(float strength, int count, const float* __restrict a, const float* __restrict mask,
                                   float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    const float m = mask == nullptr ? 1.0F : (mask[i] > 0.0F ? (mask[i] < 1.0F ? mask[i] : 1.0F) : 0.0F);
    const float w = strength * m;
    out[i] = w < 1.0F ? a[i] + w * (out[i] - a[i]) : out[i];
  }
}

/// Where one of the two is not known the other stands, as far as it has a weight; a sum of one alone is not known.
void settle_unknown(BlendMode mode, float strength, std::span<const float> a, std::span<const float> b,
                    const float* mask, std::span<float> out) {
  const bool sums = mode == BlendMode::add || mode == BlendMode::subtract;
  for (size_t i = 0; i < out.size(); ++i) {
    const bool no_a = std::isnan(a[i]), no_b = std::isnan(b[i]);
    if (!no_a && !no_b) continue;
    const bool counts = strength > 0.0F && (mask == nullptr || mask[i] > 0.0F);
    if (!counts || (no_b && !sums))
      out[i] = a[i];
    else
      out[i] = sums ? std::numeric_limits<float>::quiet_NaN() : b[i];
  }
}

void check_fits(const char* name, const GridFrame& other, const GridFrame& frame) {
  check_same_size(name, other, frame, "first terrain", "; terrain.resample brings terrains to one size");
  if (std::abs(other.cell_m - frame.cell_m) > 1e-6 * frame.cell_m) {
    throw IncompatibleInputs(std::string(name) + ": cells of " + format_number(other.cell_m) +
                             " m do not match the first terrain's " + format_number(frame.cell_m) +
                             " m; terrain.resample brings terrains to one cell size");
  }
}

}  // namespace

HeightField blend(const HeightField& a, const HeightField& b, const Mask* mask, const BlendParams& params,
                  const RunContext& run) {
  check_params(params);
  check_fits("with", b.frame(), a.frame());
  if (mask != nullptr) check_fits("mask", mask->frame(), a.frame());
  const bool smooth = params.smooth_m > 0.0 && (params.mode == BlendMode::max || params.mode == BlendMode::min);
  const float k = smooth ? static_cast<float>(0.5 / params.smooth_m) : 1.0F;
  HeightField out(a.frame());
  parallel_rows(run, a.width(), a.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      if (smooth && params.mode == BlendMode::max) {
        geom::smax_rows(a.row(y), b.row(y), k, out.row(y));
      } else if (smooth) {
        geom::smin_rows(a.row(y), b.row(y), k, out.row(y));
      } else {
        operate_row(params.mode, a.width(), a.row(y).data(), b.row(y).data(), out.row(y).data());
      }
      const float* weights = mask == nullptr ? nullptr : mask->row(y).data();
      const auto strength = static_cast<float>(params.strength);
      weigh_row(strength, a.width(), a.row(y).data(), weights, out.row(y).data());
      if (geom::any_void(a.row(y)) || geom::any_void(b.row(y)))
        settle_unknown(params.mode, strength, a.row(y), b.row(y), weights, out.row(y));
    }
  });
  return out;
}

}  // namespace seamount::terrain

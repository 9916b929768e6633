#include "seamount/geom/current/kelvinlet_rows.h"

#include <cmath>

#include "seamount/base/simd.h"

namespace seamount::geom::kelvinlets {
namespace {

template <class Real>
SEAMOUNT_INLINE Real edge(Real squared_share) {
  Real s = (squared_share - Real(0.25)) * Real(1.0 / 0.75);
  s = s > Real(0) ? (s < Real(1) ? s : Real(1)) : Real(0);
  return Real(1) - s * s * s * (s * (s * Real(6) - Real(15)) + Real(10));
}

/// A place's squared distance, 1 / r_eps and the far field's share there. Nothing where that is 0, so the centre of a
/// kernel without radius is none.
struct Far {
  float x, squared, inverse, share;
};
SEAMOUNT_INLINE Far far_at(const FarKernel& kernel, float x, float y) {
  const float squared = x * x + y * y;
  const float share = 1.0F - edge(squared * kernel.inverse_reach * kernel.inverse_reach);
  return {x, squared, std::sqrt(1.0F / (squared + kernel.eps * kernel.eps)), share};
}

}  // namespace

double near_share(double squared) { return edge(squared); }

SEAMOUNT_VECTORISED void add_round_row(const Source& source, float x0, float y, float step, float inverse_reach,
                                       int count, float* __restrict u, float* __restrict v) {
  const float eps2 = source.eps * source.eps, y2 = y * y, share = inverse_reach * inverse_reach;
  const float re = source.re, im = source.im;
  for (int i = 0; i < count; ++i) {
    const float x = x0 + static_cast<float>(i) * step;
    const float squared = x * x + y2;
    const float inverse2 = 1.0F / (squared + eps2);
    const float cube = inverse2 * std::sqrt(inverse2);
    const float f = edge(squared * share) * (cube + 1.5F * eps2 * cube * inverse2);
    u[i] += f * (re * x - im * y);
    v[i] += f * (re * y + im * x);
  }
}

SEAMOUNT_VECTORISED void add_grab_row(const Source& source, float x0, float y, float step, float inverse_reach,
                                      int count, float* __restrict u, float* __restrict v) {
  const float eps2 = source.eps * source.eps, y2 = y * y, share = inverse_reach * inverse_reach;
  const float re = source.re, im = source.im, b = source.pressed;
  for (int i = 0; i < count; ++i) {
    const float x = x0 + static_cast<float>(i) * step;
    const float squared = x * x + y2;
    const float inverse2 = 1.0F / (squared + eps2);
    const float inverse = std::sqrt(inverse2);
    const float cube = inverse2 * inverse, fade = edge(squared * share);
    const float along = fade * ((1.0F - b) * inverse + 0.5F * eps2 * cube);
    const float radial = fade * b * cube * (re * x + im * y);
    u[i] += along * re + radial * x;
    v[i] += along * im + radial * y;
  }
}

SEAMOUNT_VECTORISED void far_round_row(const FarKernel& given, int first, float y, int count, float* __restrict re,
                                       float* __restrict im) {
  const FarKernel kernel = given;
  for (int i = 0; i < count; ++i) {
    const Far far = far_at(kernel, static_cast<float>(first + i) * kernel.step, y);
    const float cube = far.inverse * far.inverse * far.inverse;
    const float falloff = far.share * (cube + 1.5F * kernel.eps * kernel.eps * cube * far.inverse * far.inverse);
    re[i] = falloff * far.x;
    im[i] = falloff * y;
  }
}

SEAMOUNT_VECTORISED void far_straight_row(const FarKernel& given, int first, float y, int count, float* __restrict re,
                                          float* __restrict im) {
  const FarKernel kernel = given;
  for (int i = 0; i < count; ++i) {
    const Far far = far_at(kernel, static_cast<float>(first + i) * kernel.step, y);
    const float cube = far.inverse * far.inverse * far.inverse;
    re[i] = far.share * (far.inverse + 0.5F * kernel.eps * kernel.eps * cube);
    im[i] = far.share * (0.5F * far.squared * cube - far.inverse);
  }
}

SEAMOUNT_VECTORISED void far_turned_row(const FarKernel& given, int first, float y, int count, float* __restrict re,
                                        float* __restrict im) {
  const FarKernel kernel = given;
  for (int i = 0; i < count; ++i) {
    const Far far = far_at(kernel, static_cast<float>(first + i) * kernel.step, y);
    const float cube = far.inverse * far.inverse * far.inverse;
    re[i] = far.share * 0.5F * (far.x * far.x - y * y) * cube;
    im[i] = far.share * far.x * y * cube;
  }
}

}  // namespace seamount::geom::kelvinlets

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

}  // namespace seamount::geom::kelvinlets

#include "seamount/geom/scalar/blend.h"

#include <cassert>
#include <cstddef>

namespace seamount::geom {
namespace {

SEAMOUNT_VECTORISED void smax_loop(const float* a, const float* b, float k, float* out, size_t count) {
  for (size_t i = 0; i < count; ++i) out[i] = smax(a[i], b[i], k);
}

SEAMOUNT_VECTORISED void smin_loop(const float* a, const float* b, float k, float* out, size_t count) {
  for (size_t i = 0; i < count; ++i) out[i] = smin(a[i], b[i], k);
}

}  // namespace

void smax_rows(std::span<const float> a, std::span<const float> b, float k, std::span<float> out) {
  assert(a.size() == b.size() && a.size() == out.size());
  smax_loop(a.data(), b.data(), k, out.data(), out.size());
}

void smin_rows(std::span<const float> a, std::span<const float> b, float k, std::span<float> out) {
  assert(a.size() == b.size() && a.size() == out.size());
  smin_loop(a.data(), b.data(), k, out.data(), out.size());
}

}  // namespace seamount::geom

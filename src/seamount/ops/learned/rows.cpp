#include "seamount/ops/learned/rows.h"

#include <algorithm>

#include "seamount/ops/learned/architecture.h"

namespace seamount::learned {
namespace {

static_assert(kThinWidth == 8 && kInnerWidth == 8);

/// Three quarters of one row and a quarter of another.
template <class T>
SEAMOUNT_INLINE void blend_rows(const T* near, const T* far, int count, float* blend) {
  for (int i = 0; i < count; ++i) blend[i] = 0.75F * number(near[i]) + 0.25F * number(far[i]);
}

template <class T>
SEAMOUNT_INLINE void add_relu(const float* near, const float* far, const T* skip, int channels, T* out) {
  for (int c = 0; c < channels; ++c) store(std::max(0.0F, 0.75F * near[c] + 0.25F * far[c] + number(skip[c])), out[c]);
}

template <class T>
SEAMOUNT_INLINE void upsample_add_relu_row(const T* near, const T* far, const T* skip, int width, int channels,
                                           float* blend, T* out) {
  blend_rows(near, far, width * channels, blend);
  const auto cell = [=](int x) { return blend + static_cast<size_t>(std::clamp(x, 0, width - 1)) * channels; };
  for (int x = 0; x < width; ++x) {
    const size_t left = 2 * static_cast<size_t>(x) * channels, right = left + channels;
    add_relu(cell(x), cell(x - 1), skip + left, channels, out + left);
    add_relu(cell(x), cell(x + 1), skip + right, channels, out + right);
  }
}

template <class T>
SEAMOUNT_INLINE void concat_cell(const float* near, const float* far, const float* plane_row, int planes, T* out) {
  for (int c = 0; c < kThinWidth; ++c) store(0.75F * near[c] + 0.25F * far[c], out[c]);
  for (int p = 0; p < planes; ++p) store(plane_row[p], out[kThinWidth + p]);
}

template <class T>
SEAMOUNT_INLINE void upsample_concat_row(const T* near, const T* far, const float* plane_row, int width, int planes,
                                         float* blend, T* out) {
  blend_rows(near, far, width * kThinWidth, blend);
  const int all = kThinWidth + planes;
  for (int x = 0; x < width; ++x) {
    const float *cell = blend + x * kThinWidth, *left = blend + std::max(0, x - 1) * kThinWidth,
                *right = blend + std::min(width - 1, x + 1) * kThinWidth;
    const size_t at = 2 * static_cast<size_t>(x);
    concat_cell(cell, left, plane_row + at * planes, planes, out + at * all);
    concat_cell(cell, right, plane_row + (at + 1) * planes, planes, out + (at + 1) * all);
  }
}

template <class T>
SEAMOUNT_INLINE void halve_row(const float* upper, const float* lower, int width, int planes, T* out) {
  const int two = 2 * planes;
  for (int x = 0; x < width; ++x) {
    const size_t at = static_cast<size_t>(x) * two;
    for (int i = 0; i < two; ++i) store(upper[at + i], out[2 * at + i]);
    for (int i = 0; i < two; ++i) store(lower[at + i], out[2 * at + two + i]);
  }
}

}  // namespace

SEAMOUNT_VECTORISED
void upsample_add_relu(const float* near, const float* far, const float* skip, int width, int channels, float* blend,
                       float* out) {
  upsample_add_relu_row(near, far, skip, width, channels, blend, out);
}
SEAMOUNT_VECTORISED
void upsample_add_relu(const Bf16* near, const Bf16* far, const Bf16* skip, int width, int channels, float* blend,
                       Bf16* out) {
  upsample_add_relu_row(near, far, skip, width, channels, blend, out);
}
SEAMOUNT_VECTORISED
void upsample_concat(const float* near, const float* far, const float* plane_row, int width, int planes, float* blend,
                     float* out) {
  upsample_concat_row(near, far, plane_row, width, planes, blend, out);
}
SEAMOUNT_VECTORISED
void upsample_concat(const Bf16* near, const Bf16* far, const float* plane_row, int width, int planes, float* blend,
                     Bf16* out) {
  upsample_concat_row(near, far, plane_row, width, planes, blend, out);
}
SEAMOUNT_VECTORISED
void halve(const float* upper, const float* lower, int width, int planes, float* out) {
  halve_row(upper, lower, width, planes, out);
}
SEAMOUNT_VECTORISED
void halve(const float* upper, const float* lower, int width, int planes, Bf16* out) {
  halve_row(upper, lower, width, planes, out);
}

SEAMOUNT_VECTORISED
void outer_row(const float* const in[3], const float* weight, float bias, int width, int count, float* out) {
  for (int x = 0; x < count; ++x) {
    float sums[kInnerWidth] = {};
    for (int dy = 0; dy < 3; ++dy) {
      const float* w = weight + dy * 3 * kInnerWidth;
      for (int dx = 0; dx < 3; ++dx) {
        if (x + dx == 0 || x + dx > width) continue;
        const float* cell = in[dy] + static_cast<size_t>(x + dx - 1) * kInnerWidth;
        for (int c = 0; c < kInnerWidth; ++c) sums[c] += w[dx * kInnerWidth + c] * cell[c];
      }
    }
    out[x] = bias + (((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7])));
  }
}

}  // namespace seamount::learned

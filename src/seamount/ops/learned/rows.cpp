#include "seamount/ops/learned/rows.h"

#include <algorithm>
#include <cstring>

#include "seamount/ops/learned/architecture.h"

namespace seamount::learned {
namespace {

static_assert(kThinWidth == 8 && kInnerWidth == 8);

/// Eight numbers that are computed at once, in whatever vectors the processor has.
using Eight = float __attribute__((vector_size(32)));

SEAMOUNT_INLINE void load(const float* from, Eight& to) { std::memcpy(&to, from, sizeof to); }

SEAMOUNT_INLINE void store_eight(const Eight& values, float* out) { std::memcpy(out, &values, sizeof values); }
/// As store() of each.
SEAMOUNT_INLINE void store_eight(const Eight& values, Bf16* out) {
  using Words = uint32_t __attribute__((vector_size(32)));
  using Halves = uint16_t __attribute__((vector_size(16)));
  Words bits;
  std::memcpy(&bits, &values, sizeof bits);
  const Halves rounded = __builtin_convertvector((bits + 0x7fffU + (bits >> 16 & 1U)) >> 16, Halves);
  std::memcpy(out, &rounded, sizeof rounded);
}

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
SEAMOUNT_INLINE void store_all(const float* values, int count, T* out) {
  int i = 0;
  for (; i + 8 <= count; i += 8) {
    Eight eight;
    load(values + i, eight);
    store_eight(eight, out + i);
  }
  for (; i < count; ++i) store(values[i], out[i]);
}

template <class T>
SEAMOUNT_INLINE void concat_cell(const float* near, const float* far, const float* plane_row, int planes, T* out) {
  Eight nearer, farther;
  load(near, nearer);
  load(far, farther);
  store_eight(0.75F * nearer + 0.25F * farther, out);
  store_all(plane_row, planes, out + kThinWidth);
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
    store_all(upper + at, two, out + 2 * at);
    store_all(lower + at, two, out + 2 * at + two);
  }
}

/// The products of a cell and its eight neighbours, by plane.
SEAMOUNT_INLINE void sum_taps(const float* const in[3], const float* weight, size_t cell, Eight& sum) {
  sum = Eight{};
  for (int dy = 0; dy < 3; ++dy) {
    for (int dx = 0; dx < 3; ++dx) {
      Eight factors, values;
      load(weight + (3 * dy + dx) * 8, factors);
      load(in[dy] + (cell + dx - 1) * 8, values);
      sum += factors * values;
    }
  }
}

/// Sums of the planes of eight cells: pairs, pairs of pairs, halves.
SEAMOUNT_INLINE void add_planes(const Eight v[8], float bias, float* out) {
  Eight two[4], four[2];
  for (int i = 0; i < 4; ++i)
    two[i] = __builtin_shufflevector(v[2 * i], v[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
             __builtin_shufflevector(v[2 * i], v[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  for (int i = 0; i < 2; ++i)
    four[i] = __builtin_shufflevector(two[2 * i], two[2 * i + 1], 0, 1, 8, 9, 4, 5, 12, 13) +
              __builtin_shufflevector(two[2 * i], two[2 * i + 1], 2, 3, 10, 11, 6, 7, 14, 15);
  const Eight sums = bias + (__builtin_shufflevector(four[0], four[1], 0, 1, 2, 3, 8, 9, 10, 11) +
                             __builtin_shufflevector(four[0], four[1], 4, 5, 6, 7, 12, 13, 14, 15));
  std::memcpy(out, &sums, sizeof sums);
}

/// A cell at any place, those at the edges too; in the same order.
SEAMOUNT_INLINE float outer_cell(const float* const in[3], const float* weight, float bias, int width, int x) {
  float v[8] = {};
  for (int dy = 0; dy < 3; ++dy) {
    for (int dx = 0; dx < 3; ++dx) {
      if (x + dx < 1 || x + dx > width) continue;
      for (int c = 0; c < 8; ++c)
        v[c] += weight[(3 * dy + dx) * 8 + c] * in[dy][static_cast<size_t>(x + dx - 1) * 8 + c];
    }
  }
  return bias + (((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7])));
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
  int x = 0;
  for (; x < std::min(1, count); ++x) out[x] = outer_cell(in, weight, bias, width, x);
  for (; x + 8 <= std::min(count, width - 1); x += 8) {
    Eight sums[8];
    for (int i = 0; i < 8; ++i) sum_taps(in, weight, static_cast<size_t>(x + i), sums[i]);
    add_planes(sums, bias, out + x);
  }
  for (; x < count; ++x) out[x] = outer_cell(in, weight, bias, width, x);
}

}  // namespace seamount::learned

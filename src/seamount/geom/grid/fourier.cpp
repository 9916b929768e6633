#include "seamount/geom/grid/fourier.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

constexpr int kLanes = 16;  // columns that are transformed together

struct Twiddles {
  explicit Twiddles(int n) : re(static_cast<size_t>(n)), im(static_cast<size_t>(n)) {
    for (int k = 0; k < n; ++k) {
      const double angle = -2.0 * std::numbers::pi * k / n;
      re[static_cast<size_t>(k)] = static_cast<float>(std::cos(angle));
      im[static_cast<size_t>(k)] = static_cast<float>(std::sin(angle));
    }
  }
  std::vector<float> re, im;  ///< exp(-2 pi i k / n)
};

/// Lanes of n complex numbers: real and imaginary parts of one number's lanes beside each other.
using Lines = std::vector<float>;

SEAMOUNT_VECTORISED void radix2(const float* __restrict from, float* __restrict to, int stride) {
  for (int q = 0; q < stride; ++q) {
    const float* a = from + static_cast<size_t>(q) * 2 * kLanes;
    const float* b = a + static_cast<size_t>(stride) * 2 * kLanes;
    float* sum = to + static_cast<size_t>(q) * 2 * kLanes;
    float* difference = sum + static_cast<size_t>(stride) * 2 * kLanes;
    for (int i = 0; i < 2 * kLanes; ++i) {
      sum[i] = a[i] + b[i];
      difference[i] = a[i] - b[i];
    }
  }
}

/// out <- w (x + i y) for lanes.
SEAMOUNT_INLINE void turned(float* __restrict out, const float* __restrict x, const float* __restrict y, float re,
                            float im) {
  for (int i = 0; i < kLanes; ++i) {
    out[i] = re * x[i] - im * y[i];
    out[kLanes + i] = re * y[i] + im * x[i];
  }
}

SEAMOUNT_VECTORISED void radix4(const float* __restrict from, float* __restrict to, int count, int stride, int n,
                                const float* twiddle_re, const float* twiddle_im) {
  const int quarter = count / 4, turn = n / count;
  const size_t step = static_cast<size_t>(quarter) * static_cast<size_t>(stride) * 2 * kLanes;
  for (int p = 0; p < quarter; ++p) {
    const int w = p * turn;
    for (int q = 0; q < stride; ++q) {
      const float* a = from + static_cast<size_t>(q + stride * p) * 2 * kLanes;
      const float *b = a + step, *c = b + step, *d = c + step;
      float* out = to + static_cast<size_t>(q + stride * 4 * p) * 2 * kLanes;
      const size_t next = static_cast<size_t>(stride) * 2 * kLanes;
      float x1[kLanes], y1[kLanes], x2[kLanes], y2[kLanes], x3[kLanes], y3[kLanes];
      for (int i = 0; i < kLanes; ++i) {
        const float sum_re = a[i] + c[i], sum_im = a[kLanes + i] + c[kLanes + i];
        const float diff_re = a[i] - c[i], diff_im = a[kLanes + i] - c[kLanes + i];
        const float other_re = b[i] + d[i], other_im = b[kLanes + i] + d[kLanes + i];
        const float across_re = b[i] - d[i], across_im = b[kLanes + i] - d[kLanes + i];
        out[i] = sum_re + other_re;
        out[kLanes + i] = sum_im + other_im;
        x1[i] = diff_re + across_im;
        y1[i] = diff_im - across_re;
        x2[i] = sum_re - other_re;
        y2[i] = sum_im - other_im;
        x3[i] = diff_re - across_im;
        y3[i] = diff_im + across_re;
      }
      turned(out + next, x1, y1, twiddle_re[w], twiddle_im[w]);
      turned(out + 2 * next, x2, y2, twiddle_re[2 * w], twiddle_im[2 * w]);
      turned(out + 3 * next, x3, y3, twiddle_re[3 * w], twiddle_im[3 * w]);
    }
  }
}

void transform_lines(Lines& lines, Lines& scratch, int n, const Twiddles& twiddles) {
  int stride = 1, count = n;
  for (; count >= 4; count /= 4, stride *= 4) {
    radix4(lines.data(), scratch.data(), count, stride, n, twiddles.re.data(), twiddles.im.data());
    lines.swap(scratch);
  }
  if (count == 2) {
    radix2(lines.data(), scratch.data(), stride);
    lines.swap(scratch);
  }
}

/// Transforms the first `columns` columns; column k becomes row k of `out`, of which numbers up to `kept` are written.
void columns_to_rows(const ComplexPlane& plane, ComplexPlane& out, int columns, int kept, const Twiddles& twiddles,
                     const RunContext& run) {
  const int n = plane.n, lanes = std::min(kLanes, n);
  parallel_blocks(run, (columns + lanes - 1) / lanes, 1, [&](int64_t block, int64_t) {
    const int first = static_cast<int>(block) * lanes;
    Lines lines(static_cast<size_t>(n) * 2 * kLanes, 0.0F), scratch(lines.size());
    bool any = false;
    for (int y = 0; y < n; ++y) {
      float* line = &lines[static_cast<size_t>(y) * 2 * kLanes];
      for (int i = 0; i < lanes; ++i) {
        line[i] = plane.re[plane.at(first + i, y)];
        line[kLanes + i] = plane.im[plane.at(first + i, y)];
        any = any || line[i] != 0.0F || line[kLanes + i] != 0.0F;
      }
    }
    if (any) transform_lines(lines, scratch, n, twiddles);
    constexpr int kTile = 16;
    for (int top = 0; top < kept; top += kTile) {
      const int bottom = std::min(kept, top + kTile);
      for (int i = 0; i < lanes; ++i) {
        float *re = &out.re[out.at(0, first + i)], *im = &out.im[out.at(0, first + i)];
        const float* line = &lines[static_cast<size_t>(i)];
        for (int y = top; y < bottom; ++y) {
          re[y] = line[static_cast<size_t>(y) * 2 * kLanes];
          im[y] = line[static_cast<size_t>(y) * 2 * kLanes + kLanes];
        }
      }
    }
  });
}

}  // namespace

void transform(ComplexPlane& plane, ComplexPlane& scratch, const RunContext& run) {
  const Twiddles twiddles(plane.n);
  columns_to_rows(plane, scratch, plane.n, plane.n, twiddles, run);
  columns_to_rows(scratch, plane, plane.n, plane.n, twiddles, run);
}

void transform_back(ComplexPlane& spectrum, ComplexPlane& scratch, int kept, const RunContext& run) {
  const int n = spectrum.n;
  const Twiddles twiddles(n);
  for (float& v : spectrum.im) v = -v;  // the inverse is the conjugate of the conjugate's transform
  columns_to_rows(spectrum, scratch, n, kept, twiddles, run);
  columns_to_rows(scratch, spectrum, kept, kept, twiddles, run);
  const float scale = 1.0F / (static_cast<float>(n) * static_cast<float>(n));
  for (float& v : spectrum.re) v *= scale;
  for (float& v : spectrum.im) v *= -scale;
}

}  // namespace seamount::geom

#include "seamount/geom/grid/upsample_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

SEAMOUNT_VECTORISED void spread_columns(const float* line, int width, float c0, float dc, int count,
                                        float* __restrict out) {
  const float last = static_cast<float>(width - 1);
  const float* __restrict one = line + 1;
  const float* __restrict two = line + 2;
  const float* __restrict three = line + 3;
  const float* __restrict four = line + 4;
  for (int i = 0; i < count; ++i) {
    float c = c0 + static_cast<float>(i) * dc;
    c = c > 0.0F ? (c < last ? c : last) : 0.0F;
    const int32_t k = static_cast<int32_t>(c);
    const float f = c - static_cast<float>(k);
    // The addresses are spelt as separate gathers: as one group of four the compiler leaves the loop scalar.
    const float a = one[k], b = two[k], d = three[k], e = four[k];
    out[i] = b + 0.5F * f * (d - a + f * (2.0F * a - 5.0F * b + 4.0F * d - e + f * (3.0F * (b - d) + e - a)));
  }
}

SEAMOUNT_VECTORISED void blend_four(const float* a, const float* b, const float* c, const float* d, const float* w,
                                    int count, float* __restrict out) {
  for (int i = 0; i < count; ++i) out[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
}

}  // namespace

GridFrame coarser_frame(const GridFrame& frame, double cell_m) {
  const double step = std::max(1.0, cell_m / frame.cell_m);
  GridFrame coarse = frame;
  coarse.cell_m = frame.cell_m * step;
  coarse.width = static_cast<int>(std::ceil(frame.width / step));
  coarse.height = static_cast<int>(std::ceil(frame.height / step));
  return coarse;
}

RowUpsampler::RowUpsampler(const ScalarField& lattice)
    : lattice_(lattice), line_(static_cast<size_t>(lattice.width()) + 5) {}

void RowUpsampler::read(double x0, double dx, double y, std::span<float> out) {
  const GridFrame& frame = lattice_.frame();
  const double row = std::clamp(frame.row(y), 0.0, frame.height - 1.0);
  const int j = static_cast<int>(row);
  const auto f = static_cast<float>(row - j);
  const auto columns = static_cast<size_t>(frame.width);
  if (f == 0.0F) {
    std::copy_n(lattice_.row(j).data(), columns, line_.data() + 2);
  } else {
    const std::array<float, 4> w = {f * (-0.5F + f * (1.0F - 0.5F * f)), 1.0F + f * f * (-2.5F + 1.5F * f),
                                    f * (0.5F + f * (2.0F - 1.5F * f)), f * f * (-0.5F + 0.5F * f)};
    const auto at = [&](int k) { return lattice_.row(std::clamp(j + k, 0, frame.height - 1)).data(); };
    blend_four(at(-1), at(0), at(1), at(2), w.data(), frame.width, line_.data() + 2);
  }
  const double first = frame.column(x0);
  if (dx == frame.cell_m && first == std::floor(first) && first >= 0 &&
      first + static_cast<double>(out.size()) <= frame.width) {
    std::copy_n(line_.data() + 2 + static_cast<std::ptrdiff_t>(first), out.size(),
                out.data());  // the lattice's own columns
    return;
  }
  line_[0] = line_[1] = line_[2];
  std::fill(line_.begin() + 2 + static_cast<std::ptrdiff_t>(columns), line_.end(), line_[1 + columns]);
  spread_columns(line_.data(), frame.width, static_cast<float>(first), static_cast<float>(dx / frame.cell_m),
                 static_cast<int>(out.size()), out.data());
}

}  // namespace seamount::geom

#include "seamount/geom/grid/sample_rows.h"

#include <cstdint>

#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

/// A position split into the cell before it and the share of the way to the next, clamped to [0, last].
struct Split {
  int32_t cell;
  float share;
};

SEAMOUNT_INLINE Split split(float v, float last) {
  v = v > 0.0F ? (v < last ? v : last) : 0.0F;
  const int32_t cell = static_cast<int32_t>(v);
  return {cell, v - static_cast<float>(cell)};
}

SEAMOUNT_INLINE int32_t below(int32_t v, int32_t limit) { return v < limit ? v : limit; }
SEAMOUNT_INLINE int32_t above_zero(int32_t v) { return v > 0 ? v : 0; }

SEAMOUNT_INLINE float catmull_rom(float a, float b, float c, float d, float f) {
  return b + 0.5F * f * (c - a + f * (2.0F * a - 5.0F * b + 4.0F * c - d + f * (3.0F * (b - c) + d - a)));
}

SEAMOUNT_VECTORISED void bilinear(const float* cells, int32_t width, int32_t height, const float* columns,
                                  const float* rows, int64_t count, float* __restrict out) {
  const float last_column = static_cast<float>(width - 1);
  const float last_row = static_cast<float>(height - 1);
  for (int64_t i = 0; i < count; ++i) {
    const Split x = split(columns[i], last_column);
    const Split y = split(rows[i], last_row);
    const int32_t x1 = below(x.cell + 1, width - 1);
    const int32_t top = y.cell * width;
    const int32_t bottom = below(y.cell + 1, height - 1) * width;
    const float upper = cells[top + x.cell] + x.share * (cells[top + x1] - cells[top + x.cell]);
    const float lower = cells[bottom + x.cell] + x.share * (cells[bottom + x1] - cells[bottom + x.cell]);
    out[i] = upper + y.share * (lower - upper);
  }
}

SEAMOUNT_VECTORISED void bicubic(const float* cells, int32_t width, int32_t height, const float* columns,
                                 const float* rows, int64_t count, float* __restrict out) {
  const float last_column = static_cast<float>(width - 1);
  const float last_row = static_cast<float>(height - 1);
  for (int64_t i = 0; i < count; ++i) {
    const Split x = split(columns[i], last_column);
    const Split y = split(rows[i], last_row);
    const int32_t x0 = above_zero(x.cell - 1), x2 = below(x.cell + 1, width - 1), x3 = below(x.cell + 2, width - 1);
    const int32_t r0 = above_zero(y.cell - 1) * width, r1 = y.cell * width;
    const int32_t r2 = below(y.cell + 1, height - 1) * width, r3 = below(y.cell + 2, height - 1) * width;
    const float a = catmull_rom(cells[r0 + x0], cells[r0 + x.cell], cells[r0 + x2], cells[r0 + x3], x.share);
    const float b = catmull_rom(cells[r1 + x0], cells[r1 + x.cell], cells[r1 + x2], cells[r1 + x3], x.share);
    const float c = catmull_rom(cells[r2 + x0], cells[r2 + x.cell], cells[r2 + x2], cells[r2 + x3], x.share);
    const float d = catmull_rom(cells[r3 + x0], cells[r3 + x.cell], cells[r3 + x2], cells[r3 + x3], x.share);
    out[i] = catmull_rom(a, b, c, d, y.share);
  }
}

}  // namespace

void sample_bilinear_rows(const Grid<float>& grid, std::span<const float> columns, std::span<const float> rows,
                          std::span<float> out) {
  bilinear(grid.data(), grid.width(), grid.height(), columns.data(), rows.data(), static_cast<int64_t>(out.size()),
           out.data());
}

void sample_bicubic_rows(const Grid<float>& grid, std::span<const float> columns, std::span<const float> rows,
                         std::span<float> out) {
  bicubic(grid.data(), grid.width(), grid.height(), columns.data(), rows.data(), static_cast<int64_t>(out.size()),
          out.data());
}

}  // namespace seamount::geom

#include "seamount/geom/grid/pyramid.h"

#include <algorithm>
#include <span>

#include "seamount/base/parallel.h"

namespace seamount::geom {

Grid<float> halved(const Grid<float>& grid, const RunContext& run) {
  GridFrame frame = grid.frame();
  frame.width = (frame.width + 1) / 2;
  frame.height = (frame.height + 1) / 2;
  frame.cell_m *= 2.0;
  frame.cut.column /= 2;  // of a window that begins at an even cell of its whole
  frame.cut.row /= 2;
  Grid<float> half(frame);
  parallel_rows(run, grid.width(), frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::span<const float> upper = grid.row(2 * y);
      const std::span<const float> lower = grid.row(std::min(2 * y + 1, grid.height() - 1));
      const std::span<float> out = half.row(y);
      const size_t pairs = upper.size() / 2;
      for (size_t x = 0; x < pairs; ++x) {
        out[x] = 0.25F * ((upper[2 * x] + upper[2 * x + 1]) + (lower[2 * x] + lower[2 * x + 1]));
      }
      if (upper.size() % 2 == 1) out[pairs] = 0.5F * (upper.back() + lower.back());
    }
  });
  return half;
}

Grid<float> doubled(const Grid<float>& grid, const GridFrame& frame, const RunContext& run) {
  constexpr float kFar = -0.0703125F, kNear = 0.8671875F, kNext = 0.2265625F, kLast = -0.0234375F;
  Grid<float> fine(frame);
  const int width = grid.width();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> mixed(static_cast<size_t>(width) + 4);
    for (int y = begin; y < end; ++y) {
      const int way = y % 2 == 0 ? -1 : 1;
      const auto row = [&](int k) { return grid.row(std::clamp(y / 2 + k * way, 0, grid.height() - 1)).data(); };
      const float *far = row(-1), *near = row(0), *next = row(1), *last = row(2);
      for (int x = 0; x < width; ++x) {
        mixed[static_cast<size_t>(x) + 2] = kFar * far[x] + kNear * near[x] + kNext * next[x] + kLast * last[x];
      }
      mixed[0] = mixed[1] = mixed[2];
      mixed[static_cast<size_t>(width) + 2] = mixed[static_cast<size_t>(width) + 3] =
          mixed[static_cast<size_t>(width) + 1];
      const std::span<float> out = fine.row(y);
      for (size_t x = 0; x < out.size() / 2; ++x) {
        const float* m = &mixed[x + 2];
        out[2 * x] = kFar * m[1] + kNear * m[0] + kNext * m[-1] + kLast * m[-2];
        out[2 * x + 1] = kFar * m[-1] + kNear * m[0] + kNext * m[1] + kLast * m[2];
      }
      if (out.size() % 2 == 1) {
        const float* m = &mixed[out.size() / 2 + 2];
        out.back() = kFar * m[1] + kNear * m[0] + kNext * m[-1] + kLast * m[-2];
      }
    }
  });
  return fine;
}

}  // namespace seamount::geom

#include "seamount/geom/grid/pyramid_fill.h"

#include <algorithm>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

struct Level {
  Grid<float> value, weight;
};

GridFrame half_of(const GridFrame& frame) {
  GridFrame half = frame;
  half.width = (frame.width + 1) / 2;
  half.height = (frame.height + 1) / 2;
  half.cell_m = 2 * frame.cell_m;
  return half;
}

/// Cells [begin, end) of the mean of two fine rows, of which each coarse cell has both columns.
SEAMOUNT_VECTORISED void pull_row(const float* const value[2], const float* const weight[2], float fade, int begin,
                                  int end, float* mean, float* kept) {
  for (int x = begin; x < end; ++x) {
    float sum = 0, weights = 0;
    for (int dy = 0; dy < 2; ++dy) {
      for (int dx = 0; dx < 2; ++dx) {
        const float w = weight[dy][2 * x + dx], v = value[dy][2 * x + dx];
        sum += w > 0 ? w * v : 0.0F;
        weights += w;
      }
    }
    mean[x] = weights > 0 ? sum / weights : 0.0F;
    kept[x] = std::min(1.0F, fade * weights);
  }
}

Level pull(const Level& fine, float fade, const RunContext& run) {
  Level coarse{Grid<float>(half_of(fine.value.frame())), Grid<float>(half_of(fine.value.frame()))};
  const int width = fine.value.width(), height = fine.value.height();
  parallel_rows(run, coarse.value.width(), coarse.value.height(), [&](int begin, int end) {
    std::vector<float> nothing(static_cast<size_t>(width), 0.0F);
    for (int y = begin; y < end; ++y) {
      const bool both = 2 * y + 1 < height;
      const float* const value[2] = {fine.value.row(2 * y).data(),
                                     both ? fine.value.row(2 * y + 1).data() : nothing.data()};
      const float* const weight[2] = {fine.weight.row(2 * y).data(),
                                      both ? fine.weight.row(2 * y + 1).data() : nothing.data()};
      float *const mean = coarse.value.row(y).data(), *const kept = coarse.weight.row(y).data();
      pull_row(value, weight, fade, 0, width / 2, mean, kept);
      if (width % 2 == 0) continue;
      const int last = width - 1;  // a column that has no other beside it
      const float last_value[4] = {value[0][last], 0, value[1][last], 0},
                  last_weight[4] = {weight[0][last], 0, weight[1][last], 0};
      const float *const v[2] = {last_value, last_value + 2}, *const w[2] = {last_weight, last_weight + 2};
      pull_row(v, w, fade, 0, 1, mean + width / 2, kept + width / 2);
    }
  });
  return coarse;
}

/// A fine cell from the coarse one that it lies in, that beside it, and those of the next nearest row.
SEAMOUNT_INLINE void between(const float* near, const float* far, int x, int beside, float* out) {
  *out = 0.5625F * near[x] + 0.1875F * (near[beside] + far[x]) + 0.0625F * far[beside];
}

/// A row of `count` fine cells from the two coarse ones that it lies between.
SEAMOUNT_VECTORISED void spread_row(const float* near, const float* far, int width, int count, float* out) {
  for (int x = 1; x < width - 1; ++x) {
    between(near, far, x, x - 1, out + 2 * x);
    between(near, far, x, x + 1, out + 2 * x + 1);
  }
  for (const int x : {0, width - 1}) {
    between(near, far, x, std::max(x - 1, 0), out + 2 * x);
    if (2 * x + 1 < count) between(near, far, x, std::min(x + 1, width - 1), out + 2 * x + 1);
  }
}

/// `spread` becomes what each cell is before it is smoothed.
SEAMOUNT_VECTORISED void keep_row(const float* value, const float* weight, int count, float* spread) {
  for (int x = 0; x < count; ++x) {
    const float w = weight[x], far = w < 1 ? spread[x] : 0.0F;
    spread[x] = w > 0 ? w * value[x] + (1 - w) * far : far;
  }
}

SEAMOUNT_INLINE float across(const float* row, int left, int x, int right) {
  return row[left] + 2 * row[x] + row[right];
}

SEAMOUNT_INLINE void smooth_cell(const float* const rows[3], const float* weight, int left, int x, int right,
                                 float* value) {
  const float smooth =
      (across(rows[0], left, x, right) + 2 * across(rows[1], left, x, right) + across(rows[2], left, x, right)) / 16;
  const float w = weight[x];
  value[x] = w * rows[1][x] + (1 - w) * (w < 1 ? smooth : 0.0F);
}

SEAMOUNT_VECTORISED void smooth_row(const float* const rows[3], const float* weight, int count, float* value) {
  for (int x = 1; x < count - 1; ++x) smooth_cell(rows, weight, x - 1, x, x + 1, value);
  for (const int x : {0, count - 1})
    smooth_cell(rows, weight, std::max(x - 1, 0), x, std::min(x + 1, count - 1), value);
}

void push(const Grid<float>& coarse, Level& fine, const RunContext& run) {
  Grid<float> spread(fine.value.frame());
  const int width = spread.width(), height = spread.height();
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const int beside = std::clamp((y & 1) != 0 ? y / 2 + 1 : y / 2 - 1, 0, coarse.height() - 1);
      float* const out = spread.row(y).data();
      spread_row(coarse.row(y / 2).data(), coarse.row(beside).data(), coarse.width(), width, out);
      keep_row(fine.value.row(y).data(), fine.weight.row(y).data(), width, out);
    }
  });
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const float* const rows[3] = {spread.row(std::max(y - 1, 0)).data(), spread.row(y).data(),
                                    spread.row(std::min(y + 1, height - 1)).data()};
      smooth_row(rows, fine.weight.row(y).data(), width, fine.value.row(y).data());
    }
  });
}

}  // namespace

void pyramid_fill(ScalarField& values, Grid<float> weight, const PyramidFill& options, const RunContext& run) {
  if (weight.width() != values.width() || weight.height() != values.height())
    throw IncompatibleInputs("values and weights are not of one size");
  std::vector<Level> levels;
  levels.push_back({std::move(values), std::move(weight)});
  while (std::max(levels.back().value.width(), levels.back().value.height()) > 1)
    levels.push_back(pull(levels.back(), options.fade, run));
  Level& top = levels.back();
  top.value(0, 0) = top.weight(0, 0) * top.value(0, 0) + (1 - top.weight(0, 0)) * options.prior;
  for (size_t level = levels.size() - 1; level-- > 0;) push(levels[level + 1].value, levels[level], run);
  values = std::move(levels.front().value);
}

}  // namespace seamount::geom

#include "seamount/geom/grid/pyramid_fill.h"

#include <algorithm>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"

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

Level pull(const Level& fine, float fade, const RunContext& run) {
  Level coarse{Grid<float>(half_of(fine.value.frame())), Grid<float>(half_of(fine.value.frame()))};
  parallel_rows(run, coarse.value.width(), coarse.value.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < coarse.value.width(); ++x) {
        float sum = 0, weights = 0;
        for (int dy = 0; dy < 2; ++dy) {
          for (int dx = 0; dx < 2; ++dx) {
            const int fx = 2 * x + dx, fy = 2 * y + dy;
            if (!fine.value.contains(fx, fy)) continue;
            const float weight = fine.weight(fx, fy);
            if (weight > 0) sum += weight * fine.value(fx, fy);
            weights += weight;
          }
        }
        coarse.value(x, y) = weights > 0 ? sum / weights : 0.0F;
        coarse.weight(x, y) = std::min(1.0F, fade * weights);
      }
    }
  });
  return coarse;
}

float between_cells(const Grid<float>& coarse, int x, int y) {
  const int cx = x / 2, cy = y / 2;
  const int nx = (x & 1) != 0 ? cx + 1 : cx - 1, ny = (y & 1) != 0 ? cy + 1 : cy - 1;
  return 0.5625F * coarse(cx, cy) + 0.1875F * (coarse.clamped(nx, cy) + coarse.clamped(cx, ny)) +
         0.0625F * coarse.clamped(nx, ny);
}

void push(const Grid<float>& coarse, Level& fine, const RunContext& run) {
  Grid<float> spread(fine.value.frame());
  parallel_rows(run, spread.width(), spread.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < spread.width(); ++x) {
        const float weight = fine.weight(x, y);
        const float far = weight < 1 ? between_cells(coarse, x, y) : 0.0F;
        spread(x, y) = weight > 0 ? weight * fine.value(x, y) + (1 - weight) * far : far;
      }
    }
  });
  parallel_rows(run, spread.width(), spread.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < spread.width(); ++x) {
        const float weight = fine.weight(x, y);
        float smooth = 0;
        if (weight < 1) {
          const auto row = [&](int v) {
            return spread.clamped(x - 1, v) + 2 * spread.clamped(x, v) + spread.clamped(x + 1, v);
          };
          smooth = (row(y - 1) + 2 * row(y) + row(y + 1)) / 16;
        }
        fine.value(x, y) = weight * spread(x, y) + (1 - weight) * smooth;
      }
    }
  });
}

}  // namespace

void pyramid_fill(ScalarField& values, const Grid<float>& weight, const PyramidFill& options, const RunContext& run) {
  if (weight.width() != values.width() || weight.height() != values.height())
    throw IncompatibleInputs("values and weights are not of one size");
  std::vector<Level> levels;
  levels.push_back({std::move(values), weight});
  while (std::max(levels.back().value.width(), levels.back().value.height()) > 1)
    levels.push_back(pull(levels.back(), options.fade, run));
  Level& top = levels.back();
  top.value(0, 0) = top.weight(0, 0) * top.value(0, 0) + (1 - top.weight(0, 0)) * options.prior;
  for (size_t level = levels.size() - 1; level-- > 0;) push(levels[level + 1].value, levels[level], run);
  values = std::move(levels.front().value);
}

}  // namespace seamount::geom

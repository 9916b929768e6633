#include "seamount/geom/solve/extrapolation.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/solve/poisson.h"

namespace seamount::geom {
namespace {

constexpr int kMostAcross = 512;
constexpr double kSeam = 3.0;  ///< coarse cells over which the floor is fitted to the border

/// The floor on cells `step` times as wide; those that hold a covered cell have the mean height of these.
struct Coarse {
  ScalarField floor;
  Grid<uint8_t> fixed;
};

Coarse means(const HeightField& heights, const Grid<uint8_t>& covered, int step, const RunContext& run) {
  GridFrame frame = heights.frame();
  frame.width = (frame.width + step - 1) / step;
  frame.height = (frame.height + step - 1) / step;
  frame.cell_m *= step;
  Coarse coarse{ScalarField(frame, 0.0F), Grid<uint8_t>(frame, uint8_t{0})};
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < frame.width; ++x) {
      double sum = 0.0;
      int count = 0;
      for (int row = y * step; row < std::min((y + 1) * step, heights.height()); ++row) {
        for (int column = x * step; column < std::min((x + 1) * step, heights.width()); ++column) {
          if (covered(column, row) == 0) continue;
          sum += static_cast<double>(heights(column, row));
          ++count;
        }
      }
      if (count == 0) continue;
      coarse.floor(x, y) = static_cast<float>(sum / count);
      coarse.fixed(x, y) = 1;
    }
  }
  return coarse;
}

/// laplace(u) of a floor whose fall through the border, by Gauss, is `slope` on average.
double bend(const Grid<uint8_t>& fixed, double slope) {
  int64_t open = 0, border = 0;
  for (int y = 0; y < fixed.height(); ++y) {
    for (int x = 0; x < fixed.width(); ++x) {
      if (fixed(x, y) != 0) continue;
      ++open;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        border += fixed.contains(x + dx, y + dy) && fixed(x + dx, y + dy) != 0 ? 1 : 0;
    }
  }
  return open == 0 ? 0.0 : slope * static_cast<double>(border) / (static_cast<double>(open) * fixed.cell_m());
}

}  // namespace

void extrapolate_ground(HeightField& heights, const Grid<uint8_t>& covered, double slope, const RunContext& run) {
  const int step = (std::max(heights.width(), heights.height()) + kMostAcross - 1) / kMostAcross;
  Coarse coarse = means(heights, covered, step, run);
  const std::span<const uint8_t> fixed = coarse.fixed.cells();
  if (std::all_of(fixed.begin(), fixed.end(), [](uint8_t f) { return f == 0; }))
    throw IncompatibleInputs("no cell of the terrain is known");
  const ScalarField rhs(coarse.floor.frame(), static_cast<float>(bend(coarse.fixed, slope)));
  solve_poisson(coarse.floor, coarse.fixed, rhs, run.part(0.0, 0.6));
  Grid<int32_t> nearest(heights.frame());
  nearest_feature(covered, nearest, run.part(0.6, 0.8));
  const auto floor_at = [&](int x, int y) {
    return static_cast<double>(sample_bilinear(coarse.floor, (x + 0.5) / step - 0.5, (y + 0.5) / step - 0.5));
  };
  const int width = heights.width();
  parallel_rows(run.part(0.8, 1.0), width, heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        if (covered(x, y) != 0) continue;
        const int32_t near = nearest(x, y);
        const int near_x = near % width, near_y = near / width;
        const double far = std::hypot(x - near_x, y - near_y) / (kSeam * step);
        double height = floor_at(x, y);
        if (far < 1.0) {
          const double off = static_cast<double>(heights(near_x, near_y)) - floor_at(near_x, near_y);
          height += (1.0 - far) * (1.0 - far) * off;
        }
        heights(x, y) = static_cast<float>(height);
      }
    }
  });
}

}  // namespace seamount::geom

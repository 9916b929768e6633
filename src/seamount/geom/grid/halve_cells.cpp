#include "seamount/geom/grid/halve_cells.h"

#include <algorithm>
#include <array>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

/// A border sees so many cells on both sides.
constexpr int kReach = 4;
/// Weights of the pairs of cells around a border, nearest first: (sqrt 3 / 2)(1 + q) q^k with q = sqrt 3 - 2, the last
/// one what they lack to a sum of 1/2.
constexpr std::array<float, kReach> kPairs = {0.6339746F, -0.16987298F, 0.04551733F, -0.00961895F};

/// border[i] = the spline between cell i - 1 and i, for i in [0, count]; cells[kReach + i] is cell i.
SEAMOUNT_VECTORISED void borders_of_row(const float* cells, float* border, int count) {
  for (int i = 0; i <= count; ++i) {
    float sum = 0.0F;
    for (int k = 0; k < kReach; ++k) sum += kPairs[k] * (cells[i + kReach - 1 - k] + cells[i + kReach + k]);
    border[i] = sum;
  }
}

/// The same across rows: rows[k] are those around the border, northernmost first.
SEAMOUNT_VECTORISED void borders_between_rows(const std::array<const float*, 2 * kReach>& rows, float* border,
                                              int count) {
  for (int i = 0; i < count; ++i) {
    float sum = 0.0F;
    for (int k = 0; k < kReach; ++k) sum += kPairs[k] * (rows[kReach - 1 - k][i] + rows[kReach + k][i]);
    border[i] = sum;
  }
}

/// The two halves of the parabola of a cell between its borders.
SEAMOUNT_VECTORISED void split_row(const float* cells, const float* border, float* halves, int count) {
  for (int i = 0; i < count; ++i) {
    const float quarter = 0.25F * (border[i] - border[i + 1]);
    halves[2 * i] = cells[i] + quarter;
    halves[2 * i + 1] = cells[i] - quarter;
  }
}

SEAMOUNT_VECTORISED void add_split_rows(const float* cells, const float* north, const float* south, float* upper,
                                        float* lower, int count) {
  for (int i = 0; i < count; ++i) {
    const float quarter = 0.25F * (north[i] - south[i]);
    upper[i] += cells[i] + quarter;
    lower[i] += cells[i] - quarter;
  }
}

/// Column or row of a cell beyond the border that a reflection comes from.
int mirrored(int i, int count) {
  if (i < 0) return std::min(-i, count - 1);
  return i < count ? i : std::max(0, 2 * (count - 1) - i);
}

/// Borders of level cells are as high as they.
void level_borders(const uint8_t* level, const float* cells, float* border, int count) {
  for (int i = 0; i < count; ++i)
    if (level[i] != 0) border[i] = border[i + 1] = cells[i];
}

}  // namespace

Grid<float> with_reflected_margin(const Grid<float>& grid, int margin, const RunContext& run) {
  GridFrame frame = grid.frame();
  frame.width += 2 * margin;
  frame.height += 2 * margin;
  Grid<float> out(frame);
  const int width = grid.width(), height = grid.height();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const int row = y - margin, edge = std::clamp(row, 0, height - 1), twin = mirrored(row, height);
      const auto at = [&](int x) { return row == edge ? grid(x, edge) : 2.0F * grid(x, edge) - grid(x, twin); };
      const std::span<float> to = out.row(y);
      for (int x = 0; x < width; ++x) to[margin + x] = at(x);
      for (int x = 1; x <= margin; ++x) {
        to[margin - x] = 2.0F * at(0) - at(mirrored(-x, width));
        to[margin + width - 1 + x] = 2.0F * at(width - 1) - at(mirrored(width - 1 + x, width));
      }
    }
  });
  return out;
}

GridFrame halved_frame(GridFrame frame) {
  frame.width *= 2;
  frame.height *= 2;
  frame.cell_m *= 0.5;
  return frame;
}

Grid<uint8_t> level_cells(const Grid<float>& grid, const RunContext& run) {
  Grid<uint8_t> level(grid.frame());
  parallel_rows(run, grid.width(), grid.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const float z = grid(x, y);
        bool same = true;
        for (int dy = -1; same && dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) same = same && grid.clamped(x + dx, y + dy) == z;
        level(x, y) = same ? 1 : 0;
      }
    }
  });
  return level;
}

void add_halved_cells(const Grid<float>& grid, const Grid<uint8_t>* level, Grid<float>& fine, const RunContext& run) {
  const int width = grid.width(), height = grid.height();
  const Grid<float> around = with_reflected_margin(grid, kReach, run.part(0.0, 0.1));
  Grid<float> wide(GridFrame{.width = 2 * width, .height = height + 2 * kReach});  // halved along rows
  parallel_rows(run.part(0.1, 0.5), wide.width(), wide.height(), [&](int begin, int end) {
    std::vector<float> border(static_cast<size_t>(width) + 1);
    for (int y = begin; y < end; ++y) {
      const float* cells = around.row(y).data();
      borders_of_row(cells, border.data(), width);
      if (level != nullptr && y >= kReach && y < kReach + height)
        level_borders(level->row(y - kReach).data(), cells + kReach, border.data(), width);
      split_row(cells + kReach, border.data(), wide.row(y).data(), width);
    }
  });
  parallel_rows(run.part(0.5, 1.0), 2 * width, height, [&](int begin, int end) {
    std::vector<float> north(2 * static_cast<size_t>(width)), south(north.size());
    // The border north of row y.
    const auto find_border = [&](int y, std::vector<float>& border) {
      std::array<const float*, 2 * kReach> rows;
      for (int k = 0; k < 2 * kReach; ++k) rows[k] = wide.row(y + k).data();
      borders_between_rows(rows, border.data(), 2 * width);
      if (level == nullptr) return;
      for (const int side : {y - 1, y}) {
        if (side < 0 || side >= height) continue;
        const std::span<const float> cells = wide.row(side + kReach);
        for (int x = 0; x < 2 * width; ++x)
          if ((*level)(x / 2, side) != 0) border[x] = cells[x];
      }
    };
    find_border(begin, north);
    for (int y = begin; y < end; ++y) {
      find_border(y + 1, south);
      add_split_rows(wide.row(y + kReach).data(), north.data(), south.data(), fine.row(2 * y).data(),
                     fine.row(2 * y + 1).data(), 2 * width);
      std::swap(north, south);
    }
  });
}

Grid<float> means_of_four(const Grid<float>& fine, const RunContext& run) {
  GridFrame frame = fine.frame();
  frame.width /= 2;
  frame.height /= 2;
  frame.cell_m *= 2.0;
  Grid<float> means(frame);
  parallel_rows(run, fine.width(), frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::span<const float> upper = fine.row(2 * y), lower = fine.row(2 * y + 1);
      for (int x = 0; x < frame.width; ++x)
        means(x, y) = 0.25F * ((upper[2 * x] + upper[2 * x + 1]) + (lower[2 * x] + lower[2 * x + 1]));
    }
  });
  return means;
}

}  // namespace seamount::geom

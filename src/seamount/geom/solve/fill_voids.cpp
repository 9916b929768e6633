#include "seamount/geom/solve/fill_voids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/solve/poisson.h"

namespace seamount::geom {
namespace {

/// A hole: cells that hang together by their sides, with the window around them.
struct Hole {
  std::vector<int64_t> cells;
  int x0, x1, y0, y1;  ///< both ends included

  int64_t window() const { return hole_window(x1 - x0 + 1, y1 - y0 + 1); }
  void add(const Hole& other) {
    cells.insert(cells.end(), other.cells.begin(), other.cells.end());
    x0 = std::min(x0, other.x0), x1 = std::max(x1, other.x1);
    y0 = std::min(y0, other.y0), y1 = std::max(y1, other.y1);
  }
};

/// Holes one by one; all as one where their windows together are much more than the grid, as those of long slanting
/// gaps between swaths are.
std::vector<Hole> solved_together(std::vector<Hole> holes, int64_t grid_cells) {
  int64_t windows = 0;
  for (const Hole& hole : holes) windows += hole.window();
  if (!filled_as_one(windows, grid_cells)) return holes;
  Hole all = std::move(holes.front());
  for (size_t i = 1; i < holes.size(); ++i) all.add(holes[i]);
  return {std::move(all)};
}

/// The hole of an unseen cell, whose cells are then seen.
Hole gather(const Grid<float>& grid, Grid<uint8_t>& seen, int64_t start) {
  const int width = grid.width();
  Hole hole{{start}, width, 0, grid.height(), 0};
  seen.data()[start] = 1;
  for (size_t at = 0; at < hole.cells.size(); ++at) {
    const int64_t cell = hole.cells[at];
    const int x = static_cast<int>(cell % width), y = static_cast<int>(cell / width);
    hole.x0 = std::min(hole.x0, x), hole.x1 = std::max(hole.x1, x);
    hole.y0 = std::min(hole.y0, y), hole.y1 = std::max(hole.y1, y);
    const auto visit = [&](int nx, int ny, int64_t next) {
      if (!grid.contains(nx, ny) || seen.data()[next] != 0 || !std::isnan(grid.data()[next])) return;
      seen.data()[next] = 1;
      hole.cells.push_back(next);
    };
    visit(x - 1, y, cell - 1);
    visit(x + 1, y, cell + 1);
    visit(x, y - 1, cell - width);
    visit(x, y + 1, cell + width);
  }
  return hole;
}

/// Calls visit(x, y, height) for what is known beside the cells of a hole, once for each side.
template <class Visit>
void for_each_of_rim(const Grid<float>& grid, const Hole& hole, const Visit& visit) {
  constexpr std::array<std::array<int, 2>, 4> kSides = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  for (const int64_t cell : hole.cells) {
    const int x = static_cast<int>(cell % grid.width()), y = static_cast<int>(cell / grid.width());
    for (const auto& [dx, dy] : kSides) {
      if (!grid.contains(x + dx, y + dy) || std::isnan(grid(x + dx, y + dy))) continue;
      visit(x + dx, y + dy, grid(x + dx, y + dy));
    }
  }
}

/// Solves in the window of a hole, of which only the hole and its rim count: whatever else lies in it is as if it were
/// at the rim's mean height.
void fill(Grid<float>& grid, const Hole& hole, const RunContext& run) {
  const int x0 = std::max(0, hole.x0 - 1), x1 = std::min(grid.width() - 1, hole.x1 + 1);
  const int y0 = std::max(0, hole.y0 - 1), y1 = std::min(grid.height() - 1, hole.y1 + 1);
  const GridFrame window = GridFrame::centred(x1 - x0 + 1, y1 - y0 + 1, grid.cell_m());
  double sum = 0;
  int64_t sides = 0;
  for_each_of_rim(grid, hole, [&](int, int, float z) { sum += static_cast<double>(z), ++sides; });
  ScalarField u(window, static_cast<float>(sides > 0 ? sum / static_cast<double>(sides) : 0.0));
  for_each_of_rim(grid, hole, [&](int x, int y, float z) { u(x - x0, y - y0) = z; });
  Grid<uint8_t> fixed(window, 1);
  for (const int64_t cell : hole.cells)
    fixed(static_cast<int>(cell % grid.width()) - x0, static_cast<int>(cell / grid.width()) - y0) = 0;
  solve_laplace(u, fixed, run);
  for (const int64_t cell : hole.cells) {
    const int x = static_cast<int>(cell % grid.width()) - x0, y = static_cast<int>(cell / grid.width()) - y0;
    grid.data()[cell] = u(x, y);
  }
}

}  // namespace

int64_t hole_window(int64_t columns, int64_t rows) { return (columns + 2) * (rows + 2); }

bool filled_as_one(int64_t windows, int64_t grid_cells) { return windows > 2 * grid_cells; }

void fill_hole(Grid<float>& window, int64_t first, const RunContext& run) {
  Grid<uint8_t> seen(window.frame(), 0);
  fill(window, gather(window, seen, first), run);
}

int64_t fill_voids(Grid<float>& grid, const RunContext& run) {
  const int64_t voids = count_voids(grid, run);
  if (voids == 0) return 0;
  if (voids == static_cast<int64_t>(grid.size()))
    throw IncompatibleInputs("none of the " + std::to_string(voids) + " cells has a value");
  Grid<uint8_t> seen(grid.frame(), 0);
  std::vector<Hole> holes;
  for (int64_t cell = 0; cell < static_cast<int64_t>(grid.size()); ++cell) {
    if (seen.data()[cell] != 0 || !std::isnan(grid.data()[cell])) continue;
    run.check_cancelled();
    holes.push_back(gather(grid, seen, cell));
  }
  int64_t filled = 0;
  const RunContext quiet{run.threads, {}, run.cancelled, {}};
  for (const Hole& hole : solved_together(std::move(holes), grid.frame().cells())) {
    fill(grid, hole, quiet);
    filled += static_cast<int64_t>(hole.cells.size());
    run.report(static_cast<double>(filled) / static_cast<double>(voids));
  }
  return voids;
}

}  // namespace seamount::geom

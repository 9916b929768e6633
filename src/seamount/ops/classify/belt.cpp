#include "seamount/ops/classify/belt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/ops/classify/steps.h"

namespace seamount::classify {
namespace {

constexpr double kCoast_m2 = 20e6;
constexpr int kLeastBelt = 3;  // ways
constexpr int kFewEdges = 4;

/// What a way meets; kBelt: a reef with the deep beyond it.
enum Met : uint8_t { kWater, kCoast, kReef, kDeep, kEdge, kBelt };

/// Bars that hang together by sides or corners, numbered from 0; -1: water.
struct Bars {
  Grid<int32_t> of;
  std::vector<bool> coast;
};

Bars find_bars(const HeightField& terrain, double bar_m) {
  Bars bars{Grid<int32_t>(terrain.frame(), -1), {}};
  const double cell_m2 = terrain.cell_m() * terrain.cell_m();
  const auto is_bar = [&](int x, int y) { return static_cast<double>(terrain(x, y)) > -bar_m; };
  std::vector<std::pair<int, int>> queue;
  for (int y = 0; y < terrain.height(); ++y) {
    for (int x = 0; x < terrain.width(); ++x) {
      if (!is_bar(x, y) || bars.of(x, y) >= 0) continue;
      const auto number = static_cast<int32_t>(bars.coast.size());
      double land_m2 = 0.0;
      queue.assign(1, {x, y});
      bars.of(x, y) = number;
      for (size_t next = 0; next < queue.size(); ++next) {
        const auto [cx, cy] = queue[next];
        land_m2 += terrain(cx, cy) > 0.0F ? cell_m2 : 0.0;
        for (int k = 0; k < 9; ++k) {
          const int nx = cx + k % 3 - 1, ny = cy + k / 3 - 1;
          if (!terrain.contains(nx, ny) || bars.of(nx, ny) >= 0 || !is_bar(nx, ny)) continue;
          bars.of(nx, ny) = number;
          queue.emplace_back(nx, ny);
        }
      }
      bars.coast.push_back(land_m2 > kCoast_m2);
    }
  }
  return bars;
}

/// Two cells of different bars, and the square of their distance in cells.
struct Link {
  int64_t squared;
  int32_t from, to;
  bool operator<(const Link& other) const {
    return std::tie(squared, from, to) < std::tie(other.squared, other.from, other.to);
  }
};

/// The shortest link between each two bars that are neighbours: whose cells are the nearest of cells side by side.
std::map<std::pair<int32_t, int32_t>, Link> find_links(const Bars& bars, double gap_cells, const RunContext& run) {
  const int width = bars.of.width(), height = bars.of.height();
  Grid<uint8_t> inside(bars.of.frame());
  for (size_t i = 0; i < inside.size(); ++i) inside.cells()[i] = bars.of.cells()[i] >= 0 ? 1 : 0;
  Grid<int32_t> nearest;
  geom::nearest_feature(inside, nearest, run);
  std::map<std::pair<int32_t, int32_t>, Link> links;
  const auto meet = [&](int32_t a, int32_t b) {
    if (a < 0 || b < 0) return;
    const int32_t first = bars.of.data()[a], second = bars.of.data()[b];
    if (first == second) return;
    if (bars.coast[static_cast<size_t>(first)] && bars.coast[static_cast<size_t>(second)]) return;
    const int64_t dx = a % width - b % width, dy = a / width - b / width;
    const Link link{dx * dx + dy * dy, std::min(a, b), std::max(a, b)};
    if (static_cast<double>(link.squared) > gap_cells * gap_cells) return;
    const auto [known, fresh] = links.try_emplace(std::minmax(first, second), link);
    if (!fresh && link < known->second) known->second = link;
  };
  for (int y = 0; y < height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) meet(nearest(x, y), nearest(x + 1, y));
      if (y + 1 < height) meet(nearest(x, y), nearest(x, y + 1));
    }
  }
  return links;
}

/// Cells of a straight way, each beside the one before.
std::vector<int32_t> cells_between(const Link& link, int width) {
  int x = link.from % width, y = link.from / width;
  const int to_x = link.to % width, to_y = link.to / width;
  const int dx = std::abs(to_x - x), dy = std::abs(to_y - y), sx = to_x > x ? 1 : -1, sy = to_y > y ? 1 : -1;
  std::vector<int32_t> cells;
  for (int64_t i = 0, j = 0; x != to_x || y != to_y;) {
    // Along the side whose next border the straight line crosses first.
    if ((2 * i + 1) * dy < (2 * j + 1) * dx)
      x += sx, ++i;
    else
      y += sy, ++j;
    cells.push_back(y * width + x);
  }
  return cells;
}

/// What stands or lies in each cell.
Grid<uint8_t> draw_obstacles(const HeightField& terrain, const Belt& belt, const RunContext& run) {
  const Bars bars = find_bars(terrain, belt.bar_m);
  Grid<uint8_t> cells(terrain.frame());
  for (size_t i = 0; i < cells.size(); ++i) {
    const int32_t bar = bars.of.cells()[i];
    const bool deep = static_cast<double>(terrain.cells()[i]) < -belt.platform_m;
    cells.cells()[i] = bar >= 0 ? (bars.coast[static_cast<size_t>(bar)] ? kCoast : kReef) : deep ? kDeep : kWater;
  }
  for (const auto& [pair, link] : find_links(bars, belt.gap_m / terrain.cell_m(), run)) {
    const std::vector<int32_t> between = cells_between(link, terrain.width());
    if (std::any_of(between.begin(), between.end(), [&](int32_t cell) { return cells.data()[cell] == kDeep; }))
      continue;
    for (const int32_t cell : between)
      if (cells.data()[cell] == kWater) cells.data()[cell] = kReef;
  }
  return cells;
}

bool stands(uint8_t obstacle) { return obstacle == kCoast || obstacle == kReef; }

/// What the step from a cell meets: kWater where the way goes on.
uint8_t met_at_once(const Grid<uint8_t>& obstacles, int x, int y, Step step) {
  if (!obstacles.contains(x + step.dx, y + step.dy)) return kEdge;
  const auto [a, b] = cells_beside(step);
  if (a.dx != 0 || a.dy != 0) {
    const uint8_t first = obstacles(x + a.dx, y + a.dy), second = obstacles(x + b.dx, y + b.dy);
    if (stands(first) && stands(second)) return std::min(first, second);  // coast rather than reef
  }
  return obstacles(x + step.dx, y + step.dy);
}

/// What ways along one direction meet: cells are visited so that the next one that way is known already.
void follow(const Grid<uint8_t>& obstacles, Step step, Grid<uint8_t>& met, const RunContext& run) {
  Grid<uint8_t> beyond(obstacles.frame());  // what is met behind all reefs
  for_each_against(obstacles.frame(), step, run, [&](int x, int y) {
    const uint8_t at_once = met_at_once(obstacles, x, y, step);
    if (at_once == kWater || at_once == kReef) {
      beyond(x, y) = beyond(x + step.dx, y + step.dy);
      met(x, y) = beyond(x, y) == kDeep ? uint8_t{kBelt} : uint8_t{kReef};
      if (at_once == kWater) met(x, y) = met(x + step.dx, y + step.dy);
    } else {
      beyond(x, y) = met(x, y) = at_once;
    }
  });
}

}  // namespace

Grid<uint8_t> behind_belt(const HeightField& terrain, const Belt& belt, const RunContext& run) {
  const Grid<uint8_t> obstacles = draw_obstacles(terrain, belt, run);
  std::vector<Grid<uint8_t>> met(kSteps.size());
  parallel_blocks(run, static_cast<int64_t>(kSteps.size()), 1, [&](int64_t begin, int64_t end) {
    for (int64_t d = begin; d < end; ++d) {
      met[static_cast<size_t>(d)] = Grid<uint8_t>(terrain.frame());
      follow(obstacles, kSteps[static_cast<size_t>(d)], met[static_cast<size_t>(d)], run);
    }
  });
  Grid<uint8_t> behind(terrain.frame());
  for (size_t i = 0; i < behind.size(); ++i) {
    std::array<int, 6> count{};
    for (const Grid<uint8_t>& way : met) ++count[way.cells()[i]];
    const int all = static_cast<int>(kSteps.size()), reefs = count[kBelt] + count[kReef];
    const bool belt_seen = count[kBelt] >= kLeastBelt || (reefs >= kLeastBelt && count[kEdge] <= kFewEdges);
    const bool shut = static_cast<double>(count[kDeep]) <= belt.open * static_cast<double>(all - count[kEdge]);
    behind.cells()[i] = obstacles.cells()[i] != kDeep && belt_seen && shut ? 1 : 0;
  }
  return behind;
}

}  // namespace seamount::classify

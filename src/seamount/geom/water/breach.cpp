#include "seamount/geom/water/breach.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <queue>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

/// Cells of a row range that lie above the sea and have no lower neighbour.
void find_pits(const HeightField& terrain, float sea, int begin, int end, std::vector<int64_t>& out) {
  const int width = terrain.width();
  for (int y = std::max(begin, 1); y < std::min(end, terrain.height() - 1); ++y) {
    const float *above = terrain.row(y - 1).data(), *at = terrain.row(y).data(), *below = terrain.row(y + 1).data();
    for (int x = 1; x + 1 < width; ++x) {
      const float z = at[x];
      if (z <= sea || at[x - 1] < z || at[x + 1] < z) continue;
      const float least = std::min({above[x - 1], above[x], above[x + 1], below[x - 1], below[x], below[x + 1]});
      if (least >= z) out.push_back(static_cast<int64_t>(y) * width + x);
    }
  }
}

/// Looks for the way from a pit to lower ground, over passes as low as can be.
class Breacher {
 public:
  Breacher(HeightField& terrain, float sea, const Grid<uint8_t>& basins)
      : terrain_(terrain), basins_(basins), sea_(sea), came_(terrain.frame(), 0) {}

  void breach(int64_t pit) {
    const float bottom = terrain_.cells()[static_cast<size_t>(pit)];
    const int64_t outlet = flood(pit, bottom);
    if (outlet >= 0) cut(pit, outlet, bottom);
    for (const int64_t cell : seen_) came_.cells()[static_cast<size_t>(cell)] = 0;
    seen_.clear();
  }

 private:
  struct Open {
    float height;
    int64_t cell;
    bool operator<(const Open& other) const {
      return height != other.height ? height > other.height : cell > other.cell;
    }
  };

  bool drains(int64_t cell, float bottom) const {
    const auto x = static_cast<int>(cell % terrain_.width()), y = static_cast<int>(cell / terrain_.width());
    const float z = terrain_.cells()[static_cast<size_t>(cell)];
    return z < bottom || z <= sea_ || (!basins_.empty() && basins_(x, y) != 0) || x == 0 || y == 0 ||
           x + 1 == terrain_.width() || y + 1 == terrain_.height();
  }

  int64_t flood(int64_t pit, float bottom) {
    const std::array<int64_t, 8> steps = flow_steps(terrain_.width());
    std::priority_queue<Open> open;
    open.push({bottom, pit});
    came_.cells()[static_cast<size_t>(pit)] = 9;
    seen_.push_back(pit);
    while (!open.empty()) {
      const int64_t cell = open.top().cell;
      open.pop();
      if (drains(cell, bottom)) return cell;
      for (size_t k = 0; k < 8; ++k) {
        const int64_t next = cell + steps[k];
        uint8_t& came = came_.cells()[static_cast<size_t>(next)];
        if (came != 0) continue;
        came = static_cast<uint8_t>(k + 1);
        seen_.push_back(next);
        open.push({terrain_.cells()[static_cast<size_t>(next)], next});
      }
    }
    return -1;
  }

  /// Lowers the way from the outlet back to the pit to the pit's height.
  void cut(int64_t pit, int64_t outlet, float bottom) {
    const std::array<int64_t, 8> steps = flow_steps(terrain_.width());
    way_.clear();
    for (int64_t cell = outlet; cell != pit;) {
      way_.push_back(cell);
      cell -= steps[static_cast<size_t>(came_.cells()[static_cast<size_t>(cell)] - 1)];
    }
    for (const int64_t cell : way_) {
      float& z = terrain_.cells()[static_cast<size_t>(cell)];
      z = std::min(z, bottom);
    }
  }

  HeightField& terrain_;
  const Grid<uint8_t>& basins_;
  float sea_;
  Grid<uint8_t> came_;  ///< 0: not seen, k + 1: by step k, 9: the pit itself
  std::vector<int64_t> seen_, way_;
};

}  // namespace

void breach_pits(HeightField& terrain, float sea_level_m, const Grid<uint8_t>& basins, const RunContext& run) {
  std::vector<std::vector<int64_t>> per_row(static_cast<size_t>(terrain.height()));
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    find_pits(terrain, sea_level_m, begin, end, per_row[static_cast<size_t>(begin)]);
  });
  std::vector<int64_t> pits;
  for (const auto& row : per_row) pits.insert(pits.end(), row.begin(), row.end());
  if (pits.empty()) return;
  std::stable_sort(pits.begin(), pits.end(), [&](int64_t a, int64_t b) {
    return terrain.cells()[static_cast<size_t>(a)] < terrain.cells()[static_cast<size_t>(b)];
  });
  Breacher breacher(terrain, sea_level_m, basins);
  for (const int64_t pit : pits) {
    run.check_cancelled();
    breacher.breach(pit);
  }
}

}  // namespace seamount::geom

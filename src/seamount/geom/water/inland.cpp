#include "seamount/geom/water/inland.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/geom/grid/voids.h"

namespace seamount::geom {
namespace {

constexpr double kLeastSea = 0.01;  // of the terrain

/// Cells [begin, end) of a row at or below the sea's level, and the water they belong to.
struct Stretch {
  int row, begin, end;
  int32_t water;
};

/// Waters: stretches that touch each other, found row by row (union-find).
class Waters {
 public:
  Waters(const HeightField& terrain, float sea, bool holes, const RunContext& run)
      : width_(terrain.width()), height_(terrain.height()) {
    size_t above = 0;
    for (int y = 0; y < height_; ++y) {
      if (y % 64 == 0) run.check_cancelled();
      const size_t first = stretches_.size();
      add_row(terrain.row(y), y, sea, holes);
      join(above, first);
      above = first;
    }
  }

  const std::vector<Stretch>& stretches() const { return stretches_; }
  bool is_sea(const Stretch& stretch, double least_cells) {
    const int32_t water = find(stretch.water);
    return edge_[static_cast<size_t>(water)] || static_cast<double>(cells_[static_cast<size_t>(water)]) >= least_cells;
  }

  bool touches_unknown(const Stretch& stretch) { return unknown_[static_cast<size_t>(find(stretch.water))]; }

 private:
  void add_row(std::span<const float> row, int y, float sea, bool holes) {
    for (int x = 0; x < width_; ++x) {
      if (!(row[static_cast<size_t>(x)] <= sea)) continue;
      const int begin = x;
      while (x < width_ && row[static_cast<size_t>(x)] <= sea) ++x;
      stretches_.push_back({y, begin, x, static_cast<int32_t>(leader_.size())});
      const auto cells = row.subspan(static_cast<size_t>(begin), static_cast<size_t>(x - begin));
      unknown_.push_back(holes && std::find(cells.begin(), cells.end(), kUnknownGround) != cells.end());
      leader_.push_back(static_cast<int32_t>(leader_.size()));
      cells_.push_back(x - begin);
      edge_.push_back(y == 0 || y == height_ - 1 || begin == 0 || x == width_);
    }
  }

  /// Joins the stretches of the last row, from `first` on, with those of the row above it that touch them.
  void join(size_t above, size_t first) {
    for (size_t i = above, k = first; i < first && k < stretches_.size();) {
      const Stretch &up = stretches_[i], &here = stretches_[k];
      if (up.end >= here.begin && up.begin <= here.end) unite(up.water, here.water);
      (up.end < here.end ? i : k) += 1;
    }
  }

  int32_t find(int32_t water) {
    while (leader_[static_cast<size_t>(water)] != water) {
      int32_t& up = leader_[static_cast<size_t>(water)];
      up = leader_[static_cast<size_t>(up)];
      water = up;
    }
    return water;
  }

  void unite(int32_t a, int32_t b) {
    a = find(a), b = find(b);
    if (a == b) return;
    const auto low = static_cast<size_t>(std::min(a, b)), high = static_cast<size_t>(std::max(a, b));
    leader_[high] = static_cast<int32_t>(low);
    cells_[low] += cells_[high];
    edge_[low] = edge_[low] || edge_[high];
    unknown_[low] = unknown_[low] || unknown_[high];
  }

  int width_, height_;
  std::vector<Stretch> stretches_;
  std::vector<int32_t> leader_;
  std::vector<int64_t> cells_;
  std::vector<bool> edge_, unknown_;
};

}  // namespace

HeightField raise_inland(HeightField terrain, float sea_level_m, const std::optional<double>& min_sea_m2,
                         const RunContext& run) {
  // Unknown cells are part of the sea, with all water that touches them.
  const bool unknown = count_voids(terrain, run) > 0;
  if (unknown) {
    for (float& z : terrain.cells())
      if (std::isnan(z)) z = kUnknownGround;
  }
  if (std::isinf(sea_level_m)) return terrain;
  const double cell_m2 = terrain.cell_m() * terrain.cell_m();
  const double least = min_sea_m2 ? *min_sea_m2 / cell_m2 : kLeastSea * static_cast<double>(terrain.size());
  Waters waters(terrain, sea_level_m, unknown, run);
  const float ground = std::nextafter(sea_level_m, INFINITY);
  for (const Stretch& stretch : waters.stretches()) {
    if (waters.is_sea(stretch, least) || (unknown && waters.touches_unknown(stretch))) continue;
    const auto row = terrain.row(stretch.row);
    std::fill(row.begin() + stretch.begin, row.begin() + stretch.end, ground);
  }
  return terrain;
}

void forget_unknown(HeightField& terrain) {
  for (float& z : terrain.cells())
    if (z == kUnknownGround) z = std::numeric_limits<float>::quiet_NaN();
}

}  // namespace seamount::geom

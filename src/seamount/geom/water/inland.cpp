#include "seamount/geom/water/inland.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "seamount/base/text.h"
#include "seamount/geom/grid/voids.h"

namespace seamount::geom {
namespace {

constexpr double kLeastSea = 0.01;       // of the terrain
constexpr float kLowRim_m = 10.0F;       // reefs and beaches around a lagoon, cells that hide a strait
constexpr float kPolder_m = 10.0F;       // the lowest ground behind dikes lies at -7 m
constexpr float kLowestDry_m = 1000.0F;  // the shores of the Dead Sea lie at -430 m, its floor at -730 m

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
  size_t water_of(const Stretch& stretch) { return static_cast<size_t>(find(stretch.water)); }

  /// Of a water that water_of() gave.
  bool is_open(size_t water) const { return edge_[water] || unknown_[water]; }
  int64_t cells(size_t water) const { return cells_[water]; }
  float lowest(size_t water) const { return lowest_[water]; }

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
      lowest_.push_back(*std::min_element(cells.begin(), cells.end()));
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
    lowest_[low] = std::min(lowest_[low], lowest_[high]);
    edge_[low] = edge_[low] || edge_[high];
    unknown_[low] = unknown_[low] || unknown_[high];
  }

  int width_, height_;
  std::vector<Stretch> stretches_;
  std::vector<int32_t> leader_;
  std::vector<int64_t> cells_;
  std::vector<float> lowest_;
  std::vector<bool> edge_, unknown_;
};

/// Calls visit(stretch) for the stretches of waters that are enclosed, and among them of those that take(water).
template <class Take, class Visit>
void for_each_enclosed(Waters& waters, const Take& take, const Visit& visit) {
  for (const Stretch& stretch : waters.stretches()) {
    const size_t water = waters.water_of(stretch);
    if (!waters.is_open(water) && take(water)) visit(stretch);
  }
}

void fill_stretch(HeightField& terrain, const Stretch& stretch, float height) {
  const auto row = terrain.row(stretch.row);
  std::fill(row.begin() + stretch.begin, row.begin() + stretch.end, height);
}

/// What enclosed waters are where nobody said how large a sea is.
class EnclosedWaters {
 public:
  EnclosedWaters(const HeightField& terrain, Waters& waters, float sea, const RunContext& run)
      : waters_(waters), sea_(sea), least_(kLeastSea * static_cast<double>(terrain.size())) {
    const auto large = [&](size_t water) { return !is_small(water); };
    bool any = false;
    for_each_enclosed(waters, large, [&](const Stretch&) { any = true; });
    if (!any) return;
    HeightField ground = terrain;
    for_each_enclosed(
        waters, [](size_t) { return true; },
        [&](const Stretch& stretch) { fill_stretch(ground, stretch, std::nextafter(sea, INFINITY)); });
    const HeightField filled = fill_depressions(ground, sea, run);
    rim_m_.assign(waters.stretches().size(), -1.0F);
    for_each_enclosed(waters, large, [&](const Stretch& stretch) {
      const size_t water = waters.water_of(stretch);
      if (rim_m_[water] >= 0.0F) return;
      rim_m_[water] = filled(stretch.begin, stretch.row) - sea;
    });
    tell(terrain.cell_m(), run);
  }

  bool is_hollow(size_t water) const {
    return !is_deep(water) && (is_small(water) || rim_m_[water] > kLowRim_m || is_shallow(water));
  }

 private:
  bool is_small(size_t water) const { return static_cast<double>(waters_.cells(water)) < least_; }
  bool is_shallow(size_t water) const { return waters_.lowest(water) >= sea_ - kPolder_m; }
  bool is_deep(size_t water) const { return waters_.lowest(water) < sea_ - kLowestDry_m; }

  const char* reason(size_t water) const {
    if (is_deep(water)) return "sea: deeper than any dry ground";
    if (is_shallow(water)) return "land: shallow as polders";
    return is_hollow(water) ? "land: behind a high rim" : "sea: behind a low rim";
  }

  void tell(double cell_m, const RunContext& run) const {
    std::map<std::string, double> km2;
    for (size_t water = 0; water < rim_m_.size(); ++water)
      if (rim_m_[water] >= 0.0F)
        km2[reason(water)] += static_cast<double>(waters_.cells(water)) * cell_m * cell_m * 1e-6;
    for (const auto& [why, area] : km2)
      run.say(format_number(std::round(area * 10.0) / 10.0) +
              " km2 below sea level without a way to the edge count as " + why + " (min_sea_m2 decides otherwise)");
  }

  Waters& waters_;
  float sea_;
  double least_;              ///< cells
  std::vector<float> rim_m_;  ///< lowest way out of large waters, over the sea
};

/// Calls visit(stretch) for the stretches of hollows. `terrain` has kUnknownGround where nothing is known.
template <class Visit>
void for_each_hollow(const HeightField& terrain, bool unknown, float sea, const std::optional<double>& min_sea_m2,
                     const RunContext& run, const Visit& visit) {
  if (std::isinf(sea)) return;
  Waters waters(terrain, sea, unknown, run);
  if (min_sea_m2) {
    const double least = *min_sea_m2 / (terrain.cell_m() * terrain.cell_m());
    for_each_enclosed(
        waters, [&](size_t water) { return static_cast<double>(waters.cells(water)) < least; }, visit);
    return;
  }
  const EnclosedWaters enclosed(terrain, waters, sea, run);
  for_each_enclosed(
      waters, [&](size_t water) { return enclosed.is_hollow(water); }, visit);
}

void mark_unknown(HeightField& terrain) {
  for (float& z : terrain.cells())
    if (std::isnan(z)) z = kUnknownGround;
}

}  // namespace

Grid<uint8_t> find_hollows(const HeightField& terrain, float sea_level_m, const std::optional<double>& min_sea_m2,
                           const RunContext& run) {
  const bool unknown = count_voids(terrain, run) > 0;
  HeightField marked;
  if (unknown) mark_unknown(marked = terrain);
  Grid<uint8_t> hollows;
  for_each_hollow(unknown ? marked : terrain, unknown, sea_level_m, min_sea_m2, run, [&](const Stretch& stretch) {
    if (hollows.empty()) hollows = Grid<uint8_t>(terrain.frame(), 0);
    const auto row = hollows.row(stretch.row);
    std::fill(row.begin() + stretch.begin, row.begin() + stretch.end, uint8_t{1});
  });
  return hollows;
}

HeightField fill_hollows(HeightField terrain, float sea_level_m, float height_m, const RunContext& run) {
  const Grid<uint8_t> hollows = find_hollows(terrain, sea_level_m, {}, run);
  for (size_t i = 0; i < hollows.size(); ++i)
    if (hollows.data()[i] != 0) terrain.data()[i] = height_m;
  return terrain;
}

HeightField raise_inland(HeightField terrain, float sea_level_m, const std::optional<double>& min_sea_m2,
                         const RunContext& run) {
  const bool unknown = count_voids(terrain, run) > 0;
  if (unknown) mark_unknown(terrain);
  std::vector<Stretch> hollows;
  for_each_hollow(terrain, unknown, sea_level_m, min_sea_m2, run,
                  [&](const Stretch& stretch) { hollows.push_back(stretch); });
  for (const Stretch& stretch : hollows) fill_stretch(terrain, stretch, std::nextafter(sea_level_m, INFINITY));
  return terrain;
}

HeightField lower_sea(HeightField terrain, float& sea_level_m, const std::optional<double>& min_sea_m2,
                      const RunContext& run) {
  const Grid<uint8_t> hollows = find_hollows(terrain, sea_level_m, min_sea_m2, run);
  const float sea = sea_level_m;
  const auto is_sea = [&](size_t i) { return terrain.data()[i] <= sea && (hollows.empty() || hollows.data()[i] == 0); };
  mark_unknown(terrain);
  float lowest = std::isinf(sea) ? 0.0F : sea;
  for (size_t i = 0; i < terrain.size(); ++i)
    if (terrain.data()[i] != kUnknownGround && !is_sea(i)) lowest = std::min(lowest, terrain.data()[i]);
  sea_level_m = lowest - 1.0F;
  for (size_t i = 0; i < terrain.size(); ++i)
    if (terrain.data()[i] != kUnknownGround && is_sea(i)) terrain.data()[i] = sea_level_m;
  return terrain;
}

void forget_unknown(HeightField& terrain) {
  for (float& z : terrain.cells())
    if (z == kUnknownGround) z = std::numeric_limits<float>::quiet_NaN();
}

}  // namespace seamount::geom

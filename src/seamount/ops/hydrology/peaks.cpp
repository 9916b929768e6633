#include "seamount/ops/hydrology/peaks.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "seamount/geom/water/flow_invert.h"
#include "seamount/geom/water/flow_passes.h"
#include "seamount/geom/water/groups.h"

namespace seamount::hydrology {
namespace {

/// The nearest higher cell, by best-first search: level 0 is the terrain, each level above holds maxima of 2 x 2.
class HigherGround {
 public:
  explicit HigherGround(const HeightField& terrain) : terrain_(terrain) {
    for (const HeightField* below = &terrain; below->width() > 1 || below->height() > 1; below = &levels_.back()) {
      GridFrame frame = below->frame();
      frame.width = (frame.width + 1) / 2;
      frame.height = (frame.height + 1) / 2;
      HeightField level(frame);
      for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
          level(x, y) = std::max(std::max((*below)(2 * x, 2 * y), below->clamped(2 * x + 1, 2 * y)),
                                 std::max(below->clamped(2 * x, 2 * y + 1), below->clamped(2 * x + 1, 2 * y + 1)));
        }
      }
      levels_.reserve(32);
      levels_.push_back(std::move(level));
    }
  }

  /// In cells; below 0 if there is none.
  double distance(int32_t cell) const {
    const int x = cell % terrain_.width(), y = cell / terrain_.width();
    const float height = terrain_(x, y);
    std::priority_queue<Box> open;
    open.push({0, static_cast<int>(levels_.size()), 0, 0});
    while (!open.empty()) {
      const Box box = open.top();
      open.pop();
      if (box.level == 0) return std::sqrt(static_cast<double>(box.squared));
      for (int k = 0; k < 4; ++k) {
        const Box child = make_box(box.level - 1, 2 * box.x + k % 2, 2 * box.y + k / 2, x, y);
        if (at(child.level).contains(child.x, child.y) && at(child.level)(child.x, child.y) > height) open.push(child);
      }
    }
    return -1.0;
  }

 private:
  struct Box {
    int64_t squared;  ///< distance from the summit to its nearest cell, squared
    int level, x, y;
    bool operator<(const Box& other) const { return squared > other.squared; }
  };

  const HeightField& at(int level) const { return level == 0 ? terrain_ : levels_[static_cast<size_t>(level - 1)]; }

  static Box make_box(int level, int box_x, int box_y, int x, int y) {
    const auto gap = [&](int box, int place) -> int64_t {
      const int64_t first = static_cast<int64_t>(box) << level, last = first + (int64_t{1} << level) - 1;
      return std::max<int64_t>({first - place, place - last, 0});
    };
    const int64_t dx = gap(box_x, x), dy = gap(box_y, y);
    return {dx * dx + dy * dy, level, box_x, box_y};
  }

  const HeightField& terrain_;
  std::vector<HeightField> levels_;
};

/// Heights over the key pass by basin of the inverted terrain; the basin 0 is none.
std::vector<double> prominences(const HeightField& inverted, const geom::Basins& basins, double lowest,
                                const RunContext& run) {
  const auto count = static_cast<size_t>(basins.count());
  std::vector<double> prominence(count, -1.0);
  std::vector<int32_t> summit(count);  // of each group, by its leader
  for (size_t i = 0; i < count; ++i) summit[i] = static_cast<int32_t>(i);
  const auto depth = [&](int32_t basin) {
    return static_cast<double>(inverted.data()[basins.pits[static_cast<size_t>(basin)]]);
  };
  geom::Groups groups(basins.count());
  for (const geom::Pass& pass : geom::find_passes(inverted, basins, run)) {
    run.check_cancelled();
    if (!(pass.height < geom::kFlowWall)) break;
    const int32_t a = groups.find(pass.a), b = groups.find(pass.b);
    if (a == b) continue;
    int32_t higher = summit[static_cast<size_t>(a)], lower = summit[static_cast<size_t>(b)];
    if (depth(lower) < depth(higher) || (depth(lower) == depth(higher) && lower < higher)) std::swap(higher, lower);
    prominence[static_cast<size_t>(lower)] = static_cast<double>(pass.height) - depth(lower);
    groups.join(a, b);
    summit[static_cast<size_t>(std::min(a, b))] = higher;
  }
  for (size_t i = 1; i < count; ++i)
    if (prominence[i] < 0.0) prominence[i] = -depth(static_cast<int32_t>(i)) - lowest;
  return prominence;
}

/// Tells of summits, one after the other, whether their level ground touches the frame, beyond which they may go on.
class FrameContact {
 public:
  explicit FrameContact(const HeightField& terrain) : terrain_(terrain), seen_(terrain.frame(), 0) {}

  bool operator()(int32_t summit) {
    const float height = terrain_.data()[summit];
    std::vector<int32_t> open{summit};
    seen_.data()[summit] = 1;
    bool touches = false;
    while (!open.empty()) {
      const int x = open.back() % terrain_.width(), y = open.back() / terrain_.width();
      open.pop_back();
      for (size_t k = 0; k < 8; ++k) {
        const int to_x = x + geom::kFlowDx[k], to_y = y + geom::kFlowDy[k];
        if (!terrain_.contains(to_x, to_y)) {
          touches = true;
        } else if (terrain_(to_x, to_y) == height && seen_(to_x, to_y) == 0) {
          seen_(to_x, to_y) = 1;
          open.push_back(to_y * terrain_.width() + to_x);
        }
      }
    }
    return touches;
  }

 private:
  const HeightField& terrain_;
  Grid<uint8_t> seen_;
};

}  // namespace

std::vector<Peak> find_peaks(const HeightField& terrain, float sea_level_m, double min_prominence_m,
                             const RunContext& run) {
  const HeightField inverted = geom::invert_with_walls(terrain, sea_level_m, run);
  const geom::Basins basins = geom::find_basins(geom::flow_directions(inverted, geom::kNoSea, run), run);
  const float lowest = std::max(sea_level_m, *std::min_element(terrain.cells().begin(), terrain.cells().end()));
  const std::vector<double> prominence = prominences(inverted, basins, static_cast<double>(lowest), run);
  FrameContact touches_frame(terrain);
  std::vector<Peak> peaks;
  for (size_t i = 1; i < prominence.size(); ++i) {
    run.check_cancelled();
    if (prominence[i] < min_prominence_m) continue;
    const int x = basins.pits[i] % inverted.width() - 1, y = basins.pits[i] / inverted.width() - 1;
    if (!terrain.contains(x, y) || terrain(x, y) <= sea_level_m) continue;  // the wall's own
    const int32_t cell = y * terrain.width() + x;
    if (touches_frame(cell)) continue;
    peaks.push_back({cell, static_cast<double>(terrain(x, y)), prominence[i], 0.0});
  }
  std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) {
    return a.prominence_m != b.prominence_m ? a.prominence_m > b.prominence_m : a.cell < b.cell;
  });
  const HigherGround higher(terrain);
  const double diagonal = std::hypot(terrain.frame().width_m(), terrain.frame().height_m());
  for (Peak& peak : peaks) {
    run.check_cancelled();
    const double cells = higher.distance(peak.cell);
    peak.isolation_m = cells < 0.0 ? diagonal : cells * terrain.cell_m();
  }
  return peaks;
}

}  // namespace seamount::hydrology

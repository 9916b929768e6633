#include "seamount/ops/sketch/courses.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/flow_passes.h"
#include "seamount/model/drawn.h"

namespace seamount::sketch {
namespace {

constexpr int32_t kNone = -1;

class Finder {
 public:
  Finder(const Runoff& runoff, const CourseParams& params, const RunContext& run)
      : from_(runoff),
        params_(params),
        width_(runoff.surface.width()),
        steps_(geom::flow_steps(width_)),
        codes_(geom::flow_directions(runoff.surface, runoff.sea_m, run)),
        ways_(codes_) {
    geom::route_through_pits(runoff.surface, ways_, runoff.highest_pass_m, run);
    basin_ = geom::find_basins(codes_, run).of;
    turned_ = Grid<uint8_t>(codes_.frame());
    for (size_t i = 0; i < codes_.size(); ++i) turned_.data()[i] = codes_.data()[i] != ways_.data()[i] ? 1 : 0;
  }

  Courses find() {
    follow_the_drops();
    uncross();
    sort_downstream();
    gather();
    find_lines();
    drop_flat();
    drop_short();
    return collect();
  }

 private:
  size_t cells() const { return codes_.size(); }
  int32_t down(int32_t cell) const {
    const uint8_t way = ways_.data()[cell];
    return way < 8 ? static_cast<int32_t>(cell + steps_[way]) : kNone;
  }
  float height(int64_t cell) const { return from_.surface.data()[cell]; }

  /// Steps stay in their basin and go down, so that with the ways from pits to passes they make no circle.
  void follow_the_drops() {
    const Grid<uint8_t> plain = ways_;
    for (size_t i = 0; i < cells(); ++i) {
      if (plain.data()[i] >= 8 || turned_.data()[i] != 0) continue;
      const auto cell = static_cast<int64_t>(i);
      int64_t most = -1;
      for (size_t k = 0; k < 8; ++k) {  // no cell of the border has a way
        const int64_t next = cell + steps_[k];
        if (!(height(next) < height(cell)) || basin_.data()[next] != basin_.data()[cell]) continue;
        const auto drops = static_cast<int64_t>(from_.passed.data()[next]);
        if (drops <= most) continue;
        most = drops;
        ways_.data()[i] = static_cast<uint8_t>(k);
      }
    }
  }

  /// Of two ways that cross between four cells the higher one joins the other.
  void uncross() {
    for (int y = 0; y + 1 < codes_.height(); ++y) {
      for (int x = 0; x + 1 < width_; ++x) {
        const int64_t at = static_cast<int64_t>(y) * width_ + x;
        // South-east is 7, north-west 3, south-west 5, north-east 1.
        const int64_t falling = ways_.data()[at] == 7 ? at : ways_.data()[at + width_ + 1] == 3 ? at + width_ + 1 : -1;
        const int64_t rising = ways_.data()[at + 1] == 5 ? at + 1 : ways_.data()[at + width_] == 1 ? at + width_ : -1;
        if (falling < 0 || rising < 0) continue;
        if (height(falling) >= height(rising))
          join(falling, rising);
        else
          join(rising, falling);
      }
    }
  }

  void join(int64_t higher, int64_t lower) {
    const int64_t target = lower + steps_[ways_.data()[lower]];
    if (turned_.data()[higher] != 0 || turned_.data()[lower] != 0 || basin_.data()[higher] != basin_.data()[target] ||
        !(height(target) < height(higher)))
      return;
    for (uint8_t k = 0; k < 8; k += 2)
      if (higher + steps_[k] == target) ways_.data()[higher] = k;
  }

  void sort_downstream() {
    std::vector<uint8_t> above(cells(), 0);
    for (size_t i = 0; i < cells(); ++i)
      if (const int32_t next = down(static_cast<int32_t>(i)); next >= 0) ++above[static_cast<size_t>(next)];
    order_.reserve(cells());
    for (size_t i = 0; i < cells(); ++i)
      if (above[i] == 0) order_.push_back(static_cast<int32_t>(i));
    for (size_t i = 0; i < order_.size(); ++i) {
      const int32_t next = down(order_[i]);
      if (next >= 0 && --above[static_cast<size_t>(next)] == 0) order_.push_back(next);
    }
  }

  bool may_end_in(int32_t cell) const {
    if (params_.basins.empty() || codes_.data()[cell] != geom::kPit) return false;
    const int32_t x = cell % width_ - from_.frame_cells, y = cell / width_ - from_.frame_cells;
    if (params_.basins(x, y) == 0) return false;
    const std::optional<WayOut> way = way_out(from_.surface, ways_, cell);
    return !way || static_cast<double>(way->depth_m) > params_.flat_m;
  }

  /// The rain that passes through each cell; ways end in basins that keep enough of it.
  void gather() {
    rain_.assign(cells(), 0.0);
    for (const int32_t cell : order_) {
      const auto i = static_cast<size_t>(cell);
      rain_[i] += from_.starts.data()[i];
      double passes = rain_[i];
      if (passes * (1.0 - params_.leave) >= params_.basin_cells && may_end_in(cell)) {
        basins_.push_back(cell);
        passes *= params_.leave;
        if (passes < params_.least_cells) ways_.data()[i] = geom::kPit;
      }
      if (const int32_t next = down(cell); next >= 0) rain_[static_cast<size_t>(next)] += passes;
    }
  }

  void find_lines() {
    line_.assign(cells(), 0);
    stem_.assign(cells(), kNone);
    for (const int32_t cell : order_) {
      const auto i = static_cast<size_t>(cell);
      line_[i] = rain_[i] >= params_.least_cells && from_.starts.data()[i] != 0 && !is_rim(cell) ? 1 : 0;
      const int32_t next = down(cell);
      if (line_[i] == 0 || next < 0) continue;
      int32_t& stem = stem_[static_cast<size_t>(next)];
      if (stem < 0 || rain_[static_cast<size_t>(stem)] < rain_[i]) stem = cell;
    }
  }

  bool is_rim(int32_t cell) const {
    return !params_.rims.empty() &&
           params_.rims(cell % width_ - from_.frame_cells, cell / width_ - from_.frame_cells) != 0;
  }

  /// Lakes lie deep below their shores, but nothing runs on them.
  bool is_level(int32_t cell) const {
    constexpr double kPart = 0.25;
    const int x = cell % width_ - from_.frame_cells, y = cell / width_ - from_.frame_cells;
    float low = from_.coarse(x, y), high = low;
    for (size_t k = 0; k < 8; ++k) {
      const float z = from_.coarse.clamped(x + geom::kFlowDx[k], y + geom::kFlowDy[k]);
      low = std::min(low, z);
      high = std::max(high, z);
    }
    return static_cast<double>(high - low) < kPart * params_.stands_out_m;
  }

  /// How far a cell lies below the ground on both sides of the line, or above it.
  double depth(int32_t cell) const {
    const auto place = [&](int32_t at) {
      const int32_t x = at % width_ - from_.frame_cells, y = at / width_ - from_.frame_cells;
      return Vec2{static_cast<double>(x), static_cast<double>(y)};
    };
    const auto after = [&](int32_t at) { return down(at) >= 0 ? down(at) : at; };
    const auto before = [&](int32_t at) {
      const int32_t stem = stem_[static_cast<size_t>(at)];
      return stem >= 0 ? stem : at;
    };
    const Vec2 at = place(cell), along = place(after(after(cell))) - place(before(before(cell)));
    const double length = std::sqrt(dot(along, along)), sign = from_.ridges ? -1.0 : 1.0;
    if (length == 0.0 || is_level(cell)) return 0.0;
    const Vec2 across{-along.y / length, along.x / length};
    const auto z = [&](double offset) {
      const Vec2 there = at + offset * across;
      return sign * static_cast<double>(geom::sample_bilinear(from_.coarse, there.x, there.y));
    };
    double most = -std::numeric_limits<double>::infinity();
    for (const double reach : {1.5, 2.5, 3.5}) most = std::max(most, std::min(z(reach), z(-reach)) - z(0.0));
    return most;
  }

  /// Rivers begin in the first valley, and go on. Ridges stand out nearly everywhere.
  void drop_flat() {
    constexpr int kGap = 4;
    constexpr int kFar = 1 << 28;
    std::vector<double> depth_of(cells(), 0.0);
    for (const int32_t cell : order_)
      if (line_[static_cast<size_t>(cell)] != 0) depth_of[static_cast<size_t>(cell)] = depth(cell);
    std::vector<int> since(cells(), kFar), until(cells(), kFar);
    for (const int32_t cell : order_) {
      const auto i = static_cast<size_t>(cell);
      if (line_[i] == 0) continue;
      const int32_t stem = stem_[i] >= 0 ? stem_[i] : cell, next = down(cell) >= 0 ? down(cell) : cell;
      const double mean =
          (depth_of[static_cast<size_t>(stem)] + depth_of[i] + depth_of[static_cast<size_t>(next)]) / 3.0;
      if (mean >= params_.stands_out_m) since[i] = until[i] = 0;
      if (next != cell) since[static_cast<size_t>(next)] = std::min(since[static_cast<size_t>(next)], since[i] + 1);
    }
    for (auto it = order_.rbegin(); it != order_.rend(); ++it) {
      const auto i = static_cast<size_t>(*it);
      if (line_[i] == 0) continue;
      if (const int32_t next = down(*it); next >= 0 && line_[static_cast<size_t>(next)] != 0)
        until[i] = std::min(until[i], until[static_cast<size_t>(next)] + 1);
      line_[i] = since[i] < kFar && (!from_.ridges || since[i] + until[i] <= kGap) ? 1 : 0;
    }
  }

  double step_length(int32_t cell) const { return static_cast<double>(geom::kFlowLength.at(ways_.data()[cell])); }

  /// Drops branches and trees that are too short, with all that joins them, which is shorter.
  void drop_short() {
    std::vector<double> length(cells(), 0.0);
    std::fill(stem_.begin(), stem_.end(), kNone);
    for (const int32_t cell : order_) {
      const int32_t next = down(cell);
      if (line_[static_cast<size_t>(cell)] == 0 || next < 0) continue;
      const double reaches = length[static_cast<size_t>(cell)] + step_length(cell);
      if (stem_[static_cast<size_t>(next)] >= 0 && reaches <= length[static_cast<size_t>(next)]) continue;
      length[static_cast<size_t>(next)] = reaches;
      stem_[static_cast<size_t>(next)] = cell;
    }
    for (auto it = order_.rbegin(); it != order_.rend(); ++it) {
      const auto i = static_cast<size_t>(*it);
      if (line_[i] == 0) continue;
      const int32_t next = down(*it);
      const bool on = next >= 0 && line_[static_cast<size_t>(next)] != 0, dropped = next >= 0 && dropped_with(next);
      const bool starts_branch = !on || stem_[static_cast<size_t>(next)] != *it;
      const double reaches = length[i] + (next >= 0 ? step_length(*it) : 0.0);
      if (dropped || (starts_branch && reaches < params_.least_length)) line_[i] = kDropped;
    }
  }

  static constexpr uint8_t kDropped = 2;
  bool dropped_with(int32_t next) const { return line_[static_cast<size_t>(next)] == kDropped; }

  Courses collect() const {
    Courses out;
    const int coarse_width = from_.coarse.width();
    const auto upright = [&](int32_t cell) {
      return (cell / width_ - from_.frame_cells) * coarse_width + cell % width_ - from_.frame_cells;
    };
    std::vector<int32_t> index(cells(), kNone);
    for (const int32_t cell : order_) {
      if (line_[static_cast<size_t>(cell)] != 1) continue;
      index[static_cast<size_t>(cell)] = static_cast<int32_t>(out.cells.size());
      out.cells.push_back(cell);
    }
    for (const int32_t cell : out.cells)
      out.down.push_back(down(cell) >= 0 ? index[static_cast<size_t>(down(cell))] : kNone);
    for (int32_t& cell : out.cells) cell = upright(cell);
    for (const int32_t cell : basins_) out.basins.push_back(upright(cell));
    return out;
  }

  const Runoff& from_;
  const CourseParams& params_;
  int width_;
  std::array<int64_t, 8> steps_;
  geom::FlowDirections codes_, ways_;  ///< steepest descent, and where lines go
  Grid<int32_t> basin_;
  Grid<uint8_t> turned_;        ///< cells between a pit and its pass
  std::vector<int32_t> order_;  ///< cells before those downstream
  std::vector<double> rain_;    ///< cells
  std::vector<uint8_t> line_;   ///< 1 on lines
  std::vector<int32_t> stem_;   ///< the most important cell that flows into each
  std::vector<int32_t> basins_;
};

}  // namespace

Courses find_courses(const Runoff& runoff, const CourseParams& params, const RunContext& run) {
  return Finder(runoff, params, run).find();
}

}  // namespace seamount::sketch

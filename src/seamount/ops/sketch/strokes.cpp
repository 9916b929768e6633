#include "seamount/ops/sketch/strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flow.h"

namespace seamount::sketch {
namespace {

class Hand {
 public:
  Hand(const Courses& courses, const HeightField& coarse, const Ground& ground, bool ridges, double flat_m)
      : courses_(courses), coarse_(coarse), ground_(ground), ridges_(ridges), flat_m_(flat_m) {}

  Strokes draw() {
    sow();
    if (!ridges_) lead_out();
    link();
    constexpr int kRounds = 12;
    const std::vector<Vec2> start = out_.places;
    for (int round = 0; round < kRounds; ++round) {
      smooth();
      pull(start);
    }
    smooth();
    return std::move(out_);
  }

 private:
  double cell_m() const { return coarse_.cell_m(); }
  Vec2 middle(int32_t cell) const {
    const int32_t x = cell % coarse_.width(), y = cell / coarse_.width();
    return {coarse_.frame().x(x), coarse_.frame().y(y)};
  }
  int32_t add(Vec2 place, int32_t down) {
    out_.places.push_back(place);
    out_.down.push_back(down);
    return static_cast<int32_t>(out_.places.size()) - 1;
  }

  /// The cells' middles keep their index; places half way between follow.
  void sow() {
    for (size_t i = 0; i < courses_.cells.size(); ++i) add(middle(courses_.cells[i]), courses_.down[i]);
    for (size_t i = 0; i < courses_.cells.size(); ++i) {
      const int32_t next = courses_.down[i];
      if (next < 0) continue;
      const Vec2 half = 0.5 * (out_.places[i] + out_.places[static_cast<size_t>(next)]);
      const int32_t between = add(half, next);
      out_.down[i] = between;
    }
  }

  void lead_out() {
    std::vector<int32_t> before(courses_.cells.size(), -1);
    for (size_t i = 0; i < courses_.cells.size(); ++i)
      if (courses_.down[i] >= 0) before[static_cast<size_t>(courses_.down[i])] = static_cast<int32_t>(i);
    for (size_t i = 0; i < courses_.cells.size(); ++i) {
      if (courses_.down[i] >= 0 || is_basin(courses_.cells[i])) continue;
      const Vec2 end = out_.places[i];
      const Vec2 heading = before[i] >= 0 ? end - out_.places[static_cast<size_t>(before[i])] : Vec2{};
      const Vec2 outlet = on_edge(courses_.cells[i]) ? edge_near(courses_.cells[i], heading) : coast_near(end, heading);
      const int32_t last = add(outlet, -1);
      out_.down[i] = add(0.5 * (end + outlet), last);
    }
  }

  bool is_basin(int32_t cell) const {
    return std::find(courses_.basins.begin(), courses_.basins.end(), cell) != courses_.basins.end();
  }
  bool on_edge(int32_t cell) const {
    const int x = cell % coarse_.width(), y = cell / coarse_.width();
    return x == 0 || y == 0 || x == coarse_.width() - 1 || y == coarse_.height() - 1;
  }

  /// Of the edges that the cell lies on, the one that the line heads for.
  Vec2 edge_near(int32_t cell, Vec2 heading) const {
    const GridFrame& frame = ground_.heights.frame();
    const int x = cell % coarse_.width(), y = cell / coarse_.width();
    const Vec2 at = middle(cell);
    Vec2 best = at;
    double most = -std::numeric_limits<double>::infinity();
    const auto offer = [&](bool there, Vec2 normal, Vec2 place) {
      if (!there || dot(normal, heading) <= most) return;
      most = dot(normal, heading);
      best = place;
    };
    offer(x == 0, {-1, 0}, {frame.west_m, at.y});
    offer(x == coarse_.width() - 1, {1, 0}, {frame.east_m(), at.y});
    offer(y == 0, {0, 1}, {at.x, frame.north_m});
    offer(y == coarse_.height() - 1, {0, -1}, {at.x, frame.south_m()});
    return best;
  }

  /// The nearest cell of sea, rather ahead than behind: a line that ends on the coarse coast has one within a few
  /// coarse cells.
  Vec2 coast_near(Vec2 from, Vec2 heading) const {
    constexpr double kFar = 4.0;     // coarse cells
    constexpr double kTurned = 0.5;  // a cell behind counts as far as (2 + 0.5) / 0.5 ahead
    const GridFrame& frame = ground_.heights.frame();
    const int x = static_cast<int>(std::lround(frame.column(from.x))),
              y = static_cast<int>(std::lround(frame.row(from.y)));
    const int reach = static_cast<int>(std::ceil(kFar * cell_m() / frame.cell_m));
    const double speed = std::max(1e-9, std::sqrt(dot(heading, heading)));
    Vec2 best = from;
    double nearest = std::numeric_limits<double>::infinity();
    for (int v = std::max(0, y - reach); v <= std::min(frame.height - 1, y + reach); ++v) {
      for (int u = std::max(0, x - reach); u <= std::min(frame.width - 1, x + reach); ++u) {
        if (ground_.is_land(static_cast<size_t>(v) * static_cast<size_t>(frame.width) + static_cast<size_t>(u)))
          continue;
        const Vec2 there{frame.x(u), frame.y(v)}, step = there - from;
        const double far = std::sqrt(dot(step, step)), cost = far * (1.0 + kTurned) - dot(step, heading) / speed;
        if (cost >= nearest) continue;
        nearest = cost;
        best = there;
      }
    }
    return best;
  }

  /// The longest line through each place, so that it stays smooth where others join.
  void link() {
    const size_t count = out_.places.size();
    std::vector<int32_t> waiting(count, 0), ready;
    std::vector<int> length(count, 0);
    up_.assign(count, -1);
    for (const int32_t next : out_.down)
      if (next >= 0) ++waiting[static_cast<size_t>(next)];
    for (size_t i = 0; i < count; ++i)
      if (waiting[i] == 0) ready.push_back(static_cast<int32_t>(i));
    for (size_t at = 0; at < ready.size(); ++at) {
      const auto i = static_cast<size_t>(ready[at]);
      if (out_.down[i] < 0) continue;
      const auto next = static_cast<size_t>(out_.down[i]);
      if (length[i] + 1 > length[next]) {
        length[next] = length[i] + 1;
        up_[next] = ready[at];
      }
      if (--waiting[next] == 0) ready.push_back(static_cast<int32_t>(next));
    }
  }

  bool is_free(size_t i) const { return up_[i] >= 0 && out_.down[i] >= 0; }

  void smooth() {
    previous_ = out_.places;
    for (size_t i = 0; i < previous_.size(); ++i) {
      if (!is_free(i)) continue;
      out_.places[i] = 0.5 * previous_[i] +
                       0.25 * (previous_[static_cast<size_t>(up_[i])] + previous_[static_cast<size_t>(out_.down[i])]);
    }
  }

  /// A step of Newton's method across the line, to where the ground is lowest.
  void pull(const std::vector<Vec2>& start) {
    constexpr double kStep = 0.15, kReach = 0.25, kFarthest = 1.0;  // coarse cells
    const double stiffness = std::max(flat_m_, 1e-6);
    for (size_t i = 0; i < out_.places.size(); ++i) {
      if (!is_free(i)) continue;
      const Vec2 along = out_.places[static_cast<size_t>(out_.down[i])] - out_.places[static_cast<size_t>(up_[i])];
      const double length = std::sqrt(dot(along, along));
      if (length == 0.0) continue;
      const Vec2 across = (1.0 / length) * Vec2{-along.y, along.x};
      const double left = z(out_.places[i] + kReach * cell_m() * across), here = z(out_.places[i]),
                   right = z(out_.places[i] - kReach * cell_m() * across);
      const double slope = (left - right) / (2.0 * kReach), bend = (left - 2.0 * here + right) / (kReach * kReach);
      const double step = std::clamp(-slope / (std::abs(bend) + stiffness), -kStep, kStep);
      const Vec2 there = out_.places[i] + step * cell_m() * across, off = there - start[i];
      if (dot(off, off) <= kFarthest * cell_m() * kFarthest * cell_m()) out_.places[i] = there;
    }
  }

  double z(Vec2 place) const {
    const double height = static_cast<double>(
        geom::sample_bspline(coarse_, coarse_.frame().column(place.x), coarse_.frame().row(place.y)));
    return ridges_ ? -height : height;
  }

  const Courses& courses_;
  const HeightField& coarse_;
  const Ground& ground_;
  bool ridges_;
  double flat_m_;
  Strokes out_;
  std::vector<int32_t> up_;
  std::vector<Vec2> previous_;
};

}  // namespace

Strokes draw_strokes(const Courses& courses, const HeightField& coarse, const Ground& ground, bool ridges,
                     double flat_m) {
  return Hand(courses, coarse, ground, ridges, flat_m).draw();
}

}  // namespace seamount::sketch

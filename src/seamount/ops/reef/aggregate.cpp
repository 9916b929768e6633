#include "seamount/ops/reef/aggregate.h"

#include <algorithm>
#include <cmath>

namespace seamount::reef {
namespace {

constexpr int kFar = 48;           // clearances are known up to this many cells
constexpr int kLaunchGap = 6;      // of the launch circle beyond the furthest site
constexpr int kShortest = 3;       // leaps need at least this clearance
constexpr double kVariance = 0.5;  // of a step to one of four neighbours, along either axis

/// Uniform on the unit circle by +, *, / and sqrt alone: the same bits everywhere.
Vec2 unit_vector(Rng& rng) {
  while (true) {
    const double u = rng.uniform(-1.0, 1.0), v = rng.uniform(-1.0, 1.0);
    const double square = u * u + v * v;
    if (square > 1.0 || square < 1e-6) continue;
    const double scale = 1.0 / std::sqrt(square);
    return {u * scale, v * scale};
  }
}

/// Chebyshev distance of every cell to the nearest settled cell, at most kFar; kept up to date as cells are added.
class Clearance {
 public:
  explicit Clearance(const GridFrame& frame) : cells_(frame, static_cast<uint8_t>(kFar)) {}

  void add(LatticeCell s) {
    const int x0 = std::max(0, s.x - kFar), x1 = std::min(cells_.width() - 1, s.x + kFar);
    for (int y = std::max(0, s.y - kFar); y <= std::min(cells_.height() - 1, s.y + kFar); ++y) {
      const int dy = std::abs(y - s.y);
      uint8_t* row = cells_.row(y).data();
      for (int x = x0; x <= x1; ++x) {
        const auto d = static_cast<uint8_t>(std::max(dy, std::abs(x - s.x)));
        row[x] = std::min(row[x], d);
      }
    }
  }

  bool occupied(LatticeCell s) const { return cells_.contains(s.x, s.y) && cells_(s.x, s.y) == 0; }

  /// A lower bound of the distance to the nearest settled cell, for places outside the grid too.
  int at(LatticeCell s) const {
    const int x = std::clamp(s.x, 0, cells_.width() - 1), y = std::clamp(s.y, 0, cells_.height() - 1);
    const int outside = std::max(std::abs(s.x - x), std::abs(s.y - y));
    const int inside = cells_(x, y);
    return outside == 0 ? inside : std::max(outside, inside - outside);
  }

 private:
  Grid<uint8_t> cells_;
};

class Growth {
 public:
  Growth(const Grid<uint8_t>& habitat, const std::vector<LatticeCell>& kernels, const WalkRules& rules)
      : habitat_(habitat), rules_(rules), clearance_(habitat.frame()) {
    speed_ = std::sqrt(dot(rules.drift, rules.drift));
    longest_ = speed_ > 0 ? 12.0 * kVariance / speed_ : 1e9;  // of leaps: one in ten of their ends is accepted
    LatticeCell low = kernels.front(), high = low;
    for (const LatticeCell s : kernels) {
      low = {std::min(low.x, s.x), std::min(low.y, s.y)};
      high = {std::max(high.x, s.x), std::max(high.y, s.y)};
    }
    centre_ = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)};
    for (const LatticeCell s : kernels) settle(s);
  }

  /// One particle: true if it found its place.
  bool shoot(Rng& rng, const RunContext& run) {
    LatticeCell p = launch(rng);
    int64_t steps = 0;
    for (int64_t moves = 1; steps < rules_.max_steps; ++moves) {
      if ((moves & 0xffff) == 0) run.check_cancelled();
      const int clear = clearance(p);
      if (clear == 1 && settles(p, rng)) {
        settle(p);
        return true;
      }
      if (clear >= kShortest) {
        const double radius = std::min(clear - 1.0, longest_);
        p = leap(p, radius, rng);
        steps += static_cast<int64_t>(speed_ > 0 ? std::min(radius * radius, radius / speed_) : radius * radius);
      } else {
        const LatticeCell next = step(p, rng);
        if (!clearance_.occupied(next)) p = next;
        ++steps;
      }
      confine(p, rng);
    }
    return false;
  }

  std::vector<LatticeCell> take() { return std::move(cells_); }

 private:
  void settle(LatticeCell s) {
    cells_.push_back(s);
    clearance_.add(s);
    const double dx = s.x - centre_.x, dy = s.y - centre_.y;
    reach_ = std::max(reach_, std::sqrt(dx * dx + dy * dy));
  }

  bool settles(LatticeCell p, Rng& rng) const {
    return habitat_.contains(p.x, p.y) && habitat_(p.x, p.y) != 0 &&
           (rules_.stickiness >= 1.0 || rng.chance(rules_.stickiness));
  }

  double from_centre(LatticeCell p) const {
    const double dx = p.x - centre_.x, dy = p.y - centre_.y;
    return std::sqrt(dx * dx + dy * dy);
  }

  int clearance(LatticeCell p) const {
    const int near = clearance_.at(p);
    if (near < kFar) return near;
    return std::max(near, static_cast<int>((from_centre(p) - reach_) * 0.7));  // 0.7: Euclidean to Chebyshev
  }

  LatticeCell on_circle(Vec2 unit) const {
    const double radius = reach_ + kLaunchGap;
    return {static_cast<int>(std::lround(centre_.x + radius * unit.x)),
            static_cast<int>(std::lround(centre_.y + radius * unit.y))};
  }

  LatticeCell launch(Rng& rng) const {
    if (rules_.launch == Launch::ring) return on_circle(unit_vector(rng));
    LatticeCell p;
    for (int tries = 0; tries < 1000; ++tries) {
      p = {rng.integer(0, habitat_.width() - 1), rng.integer(0, habitat_.height() - 1)};
      if (!clearance_.occupied(p)) return p;
    }
    return on_circle(unit_vector(rng));
  }

  LatticeCell step(LatticeCell p, Rng& rng) const {
    const double u = rng.uniform();
    const double east = 0.25 + 0.5 * rules_.drift.x, west = 0.25 - 0.5 * rules_.drift.x;
    const double north = 0.25 + 0.5 * rules_.drift.y;
    if (u < east) return {p.x + 1, p.y};
    if (u < east + west) return {p.x - 1, p.y};
    if (u < east + west + north) return {p.x, p.y - 1};
    return {p.x, p.y + 1};
  }

  LatticeCell leap(LatticeCell p, double radius, Rng& rng) const {
    Vec2 unit = unit_vector(rng);
    if (speed_ > 0) {
      const double weight = radius / kVariance;
      while (rng.uniform() >= std::exp(weight * (rules_.drift.x * unit.x - rules_.drift.y * unit.y - speed_)))
        unit = unit_vector(rng);
    }
    return {p.x + static_cast<int>(std::lround(radius * unit.x)), p.y + static_cast<int>(std::lround(radius * unit.y))};
  }

  /// Brings a walker that went too far back.
  void confine(LatticeCell& p, Rng& rng) const {
    if (rules_.launch == Launch::anywhere) {
      if (habitat_.contains(p.x, p.y)) return;
      if (speed_ > 0) {
        p = launch(rng);
        return;
      }
      p = {reflected(p.x, habitat_.width()), reflected(p.y, habitat_.height())};
      if (clearance_.occupied(p)) p = launch(rng);
      return;
    }
    const double distance = from_centre(p), radius = reach_ + kLaunchGap;
    if (distance <= radius + 2) return;
    if (speed_ > 0) {
      if (distance > 2.0 * radius + 20) p = launch(rng);
      return;
    }
    // The Moebius map (u + a) / (1 + a u) takes the uniform circle to the places where walks from 1 / a come in.
    const double a = radius / distance;
    const Vec2 u = unit_vector(rng);
    const double re = 1.0 + a * u.x, im = a * u.y, square = re * re + im * im;
    const Vec2 m{((u.x + a) * re + u.y * im) / square, (u.y * re - (u.x + a) * im) / square};
    const Vec2 out{(p.x - centre_.x) / distance, (p.y - centre_.y) / distance};
    p = on_circle({m.x * out.x - m.y * out.y, m.x * out.y + m.y * out.x});
  }

  static int reflected(int i, int count) {
    const int period = 2 * count;
    const int j = ((i % period) + period) % period;
    return j < count ? j : period - 1 - j;
  }

  const Grid<uint8_t>& habitat_;
  const WalkRules& rules_;
  Clearance clearance_;
  std::vector<LatticeCell> cells_;
  Vec2 centre_;
  double reach_ = 0.0;  ///< of the furthest site from the centre
  double speed_ = 0.0;
  double longest_ = 0.0;
};

}  // namespace

int64_t reachable_habitat(const Grid<uint8_t>& habitat, const std::vector<LatticeCell>& kernels) {
  Grid<uint8_t> seen(habitat.frame(), 0);
  std::vector<LatticeCell> front;
  const auto visit = [&](LatticeCell s) {
    if (!habitat.contains(s.x, s.y) || seen(s.x, s.y) != 0) return;
    seen(s.x, s.y) = 1;
    front.push_back(s);
  };
  for (const LatticeCell s : kernels) visit(s);
  int64_t count = 0;
  while (!front.empty()) {
    const LatticeCell s = front.back();
    front.pop_back();
    ++count;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (habitat.contains(s.x + dx, s.y + dy) && habitat(s.x + dx, s.y + dy) != 0) visit({s.x + dx, s.y + dy});
      }
    }
  }
  return count;
}

Aggregate aggregate(const Grid<uint8_t>& habitat, const std::vector<LatticeCell>& kernels, const WalkRules& rules,
                    Seed seed, const RunContext& run) {
  Aggregate out;
  run.check_cancelled();
  if (kernels.empty()) return out;
  Growth growth(habitat, kernels, rules);
  for (int i = 0; i < rules.particles; ++i) {
    if ((i & 0x3f) == 0) {
      run.check_cancelled();
      run.report(static_cast<double>(i) / rules.particles);
    }
    Rng rng(seed.derive("reef.walk", static_cast<uint64_t>(i)));
    if (!growth.shoot(rng, run)) ++out.lost;
  }
  out.cells = growth.take();
  return out;
}

}  // namespace seamount::reef

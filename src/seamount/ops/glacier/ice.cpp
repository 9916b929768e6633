#include "seamount/ops/glacier/ice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::glacier {
namespace {

constexpr double kSeconds = 3.156e7;                     // of a year
constexpr double kWeight = 910.0 * 9.81;                 // Pa per metre of ice
constexpr double kDeforming = 1.9e-24, kSlip = 5.7e-20;  // f_d, f_s
constexpr float kThinnest_m = 1.0F;                      // ice that flows
constexpr float kFast_m_yr = 60.0F;    // sliding that has half of its free speed, since ice breaks and melts
constexpr float kSteepestRise = 1.3F;  // of a bed over the fall of the ice: water freezes there, and ice sticks
constexpr int kNewton = 12;            // steps at most
constexpr float kClose_m = 0.01F;

double per_year(double rate) { return rate * kSeconds * kWeight * kWeight * kWeight; }

}  // namespace

float Climate::balance(float height) const {
  return std::min(static_cast<float>(gradient_1_yr) * (height - static_cast<float>(ela_m)),
                  static_cast<float>(most_m_yr));
}

Ice::Ice(const HeightField& bed, HeightField& surface, const Climate& climate, double sliding)
    : bed_(bed),
      surface_(surface),
      climate_(climate),
      deformation_(static_cast<float>(per_year(kDeforming))),
      sliding_(static_cast<float>(sliding * per_year(kSlip))),
      before_(bed.frame()) {}

/// A neighbour of a cell: what flows between them is flow (slope^2 + across^2) slope, with the flow of the higher one.
struct Ice::Side {
  float height, flow, across;
  float share;  ///< of the higher one's thickness that counts, to the fifth and to the third power about
};

SEAMOUNT_INLINE float Ice::flow_of(float thick) const {
  return thick * thick * thick * (deformation_ * thick * thick + sliding_);
}

/// What needs no iteration is as it was before the step: cells of one colour must not see each other at work.
SEAMOUNT_INLINE Ice::Side Ice::side(int x, int y, int dx, int dy) const {
  const int nx = x + dx, ny = y + dy;
  const auto& b = before_;
  const float across =
      static_cast<float>(0.25 / bed_.cell_m()) * (b.clamped(x - dy, y + dx) + b.clamped(nx - dy, ny + dx) -
                                                  b.clamped(x + dy, y - dx) - b.clamped(nx + dy, ny - dx));
  const float here = b(x, y) - bed_(x, y), there = b(nx, ny) - bed_(nx, ny);
  const float higher = b(x, y) > b(nx, ny) ? here : there;
  const float share = higher > 0.0F ? std::min(1.0F, 0.5F * (here + there) / higher) : 1.0F;
  return {surface_(nx, ny), flow_of(share * (surface_(nx, ny) - bed_(nx, ny))), across * across, share};
}

/// Height of a cell at which a step's budget is even, its neighbours as they are; no lower than its bed.
float Ice::settled(int x, int y, float dt) const {
  const float per_m = static_cast<float>(1.0 / bed_.cell_m()), number = dt * per_m;
  const std::array<Side, 4> sides = {side(x, y, 1, 0), side(x, y, -1, 0), side(x, y, 0, 1), side(x, y, 0, -1)};
  const float bed = bed_(x, y), before = before_(x, y), gain = dt * climate_.balance(before);
  // What a step takes away less what it brings: it grows with the height. And its derivative.
  const auto surplus = [&](float height, float& rate) {
    float sum = height - before - gain;
    rate = 1.0F;
    for (const Side& at : sides) {
      const float slope = (height - at.height) * per_m, square = slope * slope + at.across;
      float flow = at.flow;
      if (slope > 0.0F) {
        const float thick = at.share * (height - bed);
        flow = flow_of(thick);
        rate += number * at.share * thick * thick * (5.0F * deformation_ * thick * thick + 3.0F * sliding_) * square *
                slope;
      }
      sum += number * flow * square * slope;
      rate += number * flow * (square + 2.0F * slope * slope) * per_m;
    }
    return sum;
  };
  float rate = 1.0F;
  const float now = surface_(x, y);
  if (now < bed + kThinnest_m && surplus(bed, rate) >= 0.0F) return bed;
  // Newton's steps inside a bracket that they narrow.
  float low = bed, high = std::max(before + std::max(0.0F, gain), bed) + 1.0F;
  for (const Side& at : sides) high = std::max(high, at.height + 1.0F);
  float height = std::clamp(now, low, high);
  for (int i = 0; i < kNewton; ++i) {
    const float sum = surplus(height, rate);
    (sum > 0.0F ? high : low) = height;
    float next = height - sum / rate;
    if (!(next > low && next < high)) next = 0.5F * (low + high);
    if (std::abs(next - height) < kClose_m) return next;
    height = next;
  }
  return height;
}

void Ice::step(double years, int sweeps, const RunContext& run) {
  const int width = bed_.width(), height = bed_.height();
  const auto dt = static_cast<float>(years);
  std::copy(surface_.cells().begin(), surface_.cells().end(), before_.cells().begin());
  const auto may_hold = [&](int x, int y) {
    const auto thick = [&](int nx, int ny) { return surface_(nx, ny) > bed_(nx, ny); };
    return thick(x, y) || surface_(x, y) > static_cast<float>(climate_.ela_m) || thick(x + 1, y) || thick(x - 1, y) ||
           thick(x, y + 1) || thick(x, y - 1);
  };
  for (int sweep = 0; sweep < 2 * sweeps; ++sweep) {
    parallel_rows(run, width, height, [&](int begin, int end) {
      for (int y = std::max(1, begin); y < std::min(height - 1, end); ++y) {
        for (int x = 1 + ((y + sweep) & 1); x < width - 1; x += 2) {
          if (may_hold(x, y)) surface_(x, y) = settled(x, y, dt);
        }
      }
    });
  }
}

void Ice::slide(ScalarField& speed, const RunContext& run) const {
  const int width = bed_.width(), height = bed_.height();
  const float half = static_cast<float>(0.5 / bed_.cell_m());
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        const float thick = surface_(x, y) - bed_(x, y);
        const float dx = half * (surface_.clamped(x + 1, y) - surface_.clamped(x - 1, y));
        const float dy = half * (surface_.clamped(x, y + 1) - surface_.clamped(x, y - 1));
        const float square = dx * dx + dy * dy;
        if (thick < kThinnest_m || square <= 0.0F) {
          speed(x, y) = 0.0F;
          continue;
        }
        const float ex = half * (bed_.clamped(x + 1, y) - bed_.clamped(x - 1, y));
        const float ey = half * (bed_.clamped(x, y + 1) - bed_.clamped(x, y - 1));
        // How steeply the bed rises down the ice, over the slope of the ice.
        const float adverse = std::max(0.0F, -(dx * ex + dy * ey) / square);
        const float free = sliding_ * thick * thick * square * std::sqrt(square);
        speed(x, y) = std::max(0.0F, 1.0F - adverse / kSteepestRise) * free / (1.0F + free / kFast_m_yr);
      }
    }
  });
}

Budget Ice::budget() const {
  Budget sum;
  const float per_m = static_cast<float>(1.0 / bed_.cell_m());
  for (int y = 1; y + 1 < bed_.height(); ++y) {
    for (int x = 1; x + 1 < bed_.width(); ++x) {
      const float here = surface_(x, y), balance = climate_.balance(here);
      if (balance > 0.0F) sum.gained += balance;
      if (balance > 0.0F) continue;
      float inflow = 0.0F;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const Side at = side(x, y, dx, dy);
        const float slope = std::max(0.0F, (at.height - here) * per_m);
        inflow += at.flow * (slope * slope + at.across) * slope * per_m;
      }
      sum.lost += here > bed_(x, y) ? -balance : std::min(-balance, inflow);
    }
  }
  const double area = bed_.cell_m() * bed_.cell_m();
  return {sum.gained * area, sum.lost * area};
}

}  // namespace seamount::glacier

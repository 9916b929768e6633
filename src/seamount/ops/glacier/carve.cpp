#include "seamount/ops/glacier/carve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::glacier {
namespace {

constexpr float kIce_m = 5.0F;        // that carves
constexpr float kLeastShare = 0.05F;  // of ice around a place, that means over it divide by
constexpr float kMostSlope = 3.0F;    // of a bed that wears at right angles
constexpr float kMostWorn = 0.5F;     // of a cell, in a step
constexpr float kCarved_m = 0.5F;     // that makes a wall of what stands over it

/// Lowers walls over carved ground, by fast sweeping (Zhao 2005).
class Walls {
 public:
  Walls(const HeightField& start, HeightField& bed, double angle_deg)
      : start_(start),
        bed_(bed),
        rise_(static_cast<float>(std::tan(angle_deg * std::numbers::pi / 180) * bed.cell_m())) {}

  void sweep(int way) {
    const int width = bed_.width(), height = bed_.height();
    for (int k = 0; k < height; ++k) {
      const int y = way > 0 ? k : height - 1 - k;
      for (int x = 0; x < width; ++x) cell(x, y);
      for (int x = width - 1; x >= 0; --x) cell(x, y);
    }
  }

 private:
  /// To where the gradient from the lower carved ground in x and in y is the limit (Godunov's upwind differences).
  void cell(int x, int y) {
    constexpr float kNone = std::numeric_limits<float>::infinity();
    const auto carved = [&](int nx, int ny) {
      if (!bed_.contains(nx, ny)) return kNone;
      const float there = bed_(nx, ny);
      return start_(nx, ny) - there > kCarved_m ? there : kNone;
    };
    const float a = std::min(carved(x - 1, y), carved(x + 1, y)), b = std::min(carved(x, y - 1), carved(x, y + 1));
    const float low = std::min(a, b), apart = std::abs(a - b);
    float& here = bed_(x, y);
    if (!(here - low > 0.7F * rise_)) return;
    here =
        std::min(here, apart < rise_ ? 0.5F * (a + b + std::sqrt(2.0F * rise_ * rise_ - apart * apart)) : low + rise_);
  }

  const HeightField& start_;
  HeightField& bed_;
  float rise_;
};

}  // namespace

void carve(const HeightField& start, const ScalarField& hardness, const Carving& carving, ScalarField& speed,
           HeightField& bed, HeightField& surface, const RunContext& run) {
  for (size_t i = 0; i < bed.size(); ++i) surface.data()[i] -= bed.data()[i];  // thickness, for now
  const ScalarField& ice = surface;
  ScalarField share(bed.frame());
  for (size_t i = 0; i < share.size(); ++i) share.data()[i] = ice.data()[i] > kIce_m ? 1.0F : 0.0F;
  geom::gaussian_blur(share, carving.widening_m, run);
  geom::gaussian_blur(speed, carving.widening_m, run);
  const HeightField before = bed;
  const int width = bed.width();
  const float half = static_cast<float>(0.5 / bed.cell_m());
  const auto rate = static_cast<float>(carving.abrasion * carving.years);
  parallel_rows(run, width, bed.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        if (ice(x, y) <= kIce_m) continue;
        const float dx = half * (before.clamped(x + 1, y) - before.clamped(x - 1, y));
        const float dy = half * (before.clamped(x, y + 1) - before.clamped(x, y - 1));
        const float slope = std::min(kMostSlope, std::hypot(dx, dy));
        const float slid = speed(x, y) / std::max(kLeastShare, share(x, y));
        const float hard = hardness.empty() ? 1.0F : hardness(x, y);
        bed(x, y) -= std::min(kMostWorn * ice(x, y), rate * slid * std::sqrt(1.0F + slope * slope) / hard);
      }
    }
  });
  Walls walls(start, bed, carving.wall_angle_deg);
  for (const int way : {1, -1}) run.check_cancelled(), walls.sweep(way);
  for (size_t i = 0; i < bed.size(); ++i) surface.data()[i] += bed.data()[i];
}

}  // namespace seamount::glacier

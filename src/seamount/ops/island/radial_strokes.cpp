#include "seamount/ops/island/radial_strokes.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace seamount::island {

std::vector<Stroke> radial_strokes(int count, double width_m, double strength_m, Vec2 centre, double reach_m,
                                   Seed seed) {
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    Rng rng(seed.derive("island.radial", static_cast<uint64_t>(i)));
    const double angle = 2.0 * std::numbers::pi * (i + rng.uniform(-0.35, 0.35)) / count;
    const double bend = rng.uniform(-0.12, 0.12);
    Stroke stroke;
    for (const double share : {0.08, 0.35, 0.7, 1.0}) {
      const double a = angle + bend * std::sin(3.0 * share);
      stroke.points.push_back(centre + (share * reach_m) * Vec2{std::cos(a), std::sin(a)});
    }
    stroke.width_m = width_m * rng.uniform(0.7, 1.3);
    stroke.strength_m = (i % 2 == 0 ? 1.0 : -1.0) * strength_m * rng.uniform(0.7, 1.3);
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

}  // namespace seamount::island

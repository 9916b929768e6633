#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {

ThingMesh make_arch(const ThingMaking& m) {
  constexpr double kPi = std::numbers::pi;
  Rng rng(m.seed.derive("form"));
  const Seed grain = m.seed.derive("grain");
  const int steps = m.by_level(46, 18, 5), sides = m.by_level(16, 8, 4);
  const double thick = rng.uniform(0.14, 0.19), skew = rng.uniform(-0.22, 0.22), crown = rng.uniform(0.8, 1.15);
  const double bend = rng.uniform(-0.10, 0.10), other_leg = rng.uniform(1.1, 1.7), bedding = rng.uniform(7.0, 11.0);
  const Tone main = m.main(0x9C8468), dark = mix(main, tone(0x6B5746), 0.75);
  const auto beds = [&](double z) { return noise3(grain, {0.0, 0.0, bedding * z}); };
  std::vector<Ring3> rings;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, angle = kPi * (1.0 - t);
    const double flare = std::pow(std::abs(2.0 * t - 1.0), 1.8);
    const double across = std::cos(angle);
    const Point3 centre{0.72 * std::copysign(std::pow(std::abs(across), 0.75), across) + skew * std::sin(angle),
                        bend * std::sin(2.0 * angle), std::pow(std::max(0.0, std::sin(angle)), 0.6) * 0.80};
    const double leg = t < 0.5 ? 1.0 : other_leg;
    const double radius = thick * (crown + flare * leg * 1.1) * (1.0 + 0.22 * noise3(grain, 3.0 * centre));
    const double contact = 0.68 + 0.32 * std::clamp(centre.z / 0.25, 0.0, 1.0);
    const double stripe = std::clamp(0.5 + 0.9 * beds(centre.z), 0.0, 1.0);
    rings.push_back({centre, radius, contact * mix(dark, main, 0.35 + 0.65 * stripe)});
  }
  ThingBuilder builder;
  builder.tube(rings, sides, [&](size_t i, double angle) {
    const Point3 at = rings[i].centre + 0.4 * Point3{std::cos(angle), std::sin(angle), 0.3 * std::cos(angle)};
    const double blocky =
        std::pow(std::pow(std::abs(std::cos(angle)), 5.0) + std::pow(std::abs(std::sin(angle)), 5.0), -0.2);
    const double z = rings[i].centre.z + 0.2 * rings[i].radius * std::sin(angle);
    const double bed = std::floor(12.0 * z + 0.7 * noise3(grain, 3.0 * at));
    const double ledge = noise3(grain, {0.37 * bed, 5.3, 0.71 * bed});  // each bed stands out or back as a whole
    return blocky * (0.86 + 0.16 * noise3(grain, 2.6 * at) + 0.15 * noise3(grain, 7.0 * at) + 0.22 * ledge);
  });
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

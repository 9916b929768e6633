#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/geom/things/coral_tone.h"
#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {

ThingMesh make_foliose_coral(const ThingMaking& m) {
  Rng rng(m.seed.derive("plates"));
  const Seed wave = m.seed.derive("wave");
  const Tone live = colony_tone(m, 0x86705A), rim = mix(live, bleached(tone(0xD8CBB4), m.health), 0.65);
  const int plates = m.by_level(21, 14, 7);
  const int across = m.by_level(9, 4, 2), along = m.by_level(4, 2, 1);
  ThingBuilder builder;
  builder.blob(
      0,
      [](Point3 d) {
        return Point3{0.3 * d.x, 0.3 * d.y, 0.12 + 0.16 * d.z};
      },
      [&](Point3) { return 0.4 * live; });
  for (int i = 0; i < plates; ++i) {
    const double out = std::sqrt((i + 0.6) / plates), bearing = 2.39996 * i + rng.uniform(-0.25, 0.25);
    const double open = rng.uniform(0.9, 1.35), upright = 1.25 - 0.95 * out + rng.uniform(-0.12, 0.12);
    const double reach = rng.uniform(0.5, 0.66) * (0.75 + 0.35 * out), lot = rng.uniform();
    const Seed own = wave.derive("plate", static_cast<uint64_t>(i));
    const Point3 foot{0.30 * out * std::cos(bearing), 0.30 * out * std::sin(bearing), 0.08};
    const auto place = [&](double u, double v) {
      const double angle = bearing + open * (u - 0.5) * (1.0 + 0.5 * v);
      const double rise = upright - 0.45 * v * v;  // curls outwards
      const double lobe = 1.0 - 0.22 * std::pow(std::abs(2.0 * u - 1.0), 3.0) + 0.14 * noise3(own, {3.0 * u, 2.0, 0.0});
      Point3 p = foot + (reach * lobe * (0.06 + 0.94 * v)) * direction(angle, rise);
      p.z += 0.05 * v * noise3(own, {3.0 * u, 2.0 * v, 1.0});
      return p;
    };
    builder.missing(!m.has(lot, 0.4));
    builder.sheet(across, along, place, [&](double, double v) {
      return (0.36 + 0.64 * v) * mix(live, rim, std::clamp(6.0 * (v - 0.8), 0.0, 1.0));
    });
  }
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

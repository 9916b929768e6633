#include <algorithm>
#include <cmath>

#include "seamount/geom/things/coral_tone.h"
#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {

ThingMesh make_massive_coral(const ThingMaking& m) {
  Rng rng(m.seed.derive("form"));
  const Seed lobes = m.seed.derive("lobes"), folds = m.seed.derive("folds"), death = m.seed.derive("death");
  const double lumpy = rng.uniform(0.05, 0.15), fine = rng.uniform(4.2, 6.0), lean = rng.uniform(0.0, 0.12);
  const Tone live = colony_tone(m, 0x80745A, 0.16), groove = 0.5 * live;
  const Tone dead = bleached(tone(0x9A937F), std::min(1.0, m.health + 0.3));
  const auto relief = [&](Point3 d) {  // meandering ridges
    const Point3 at = fine * d + 0.9 * Point3{noise3(folds, 3.0 * d), noise3(lobes, 3.3 * d), noise3(death, 3.1 * d)};
    return 1.0 - std::min(1.0, 2.6 * std::abs(noise3(folds, at)));
  };
  const auto place = [&](Point3 d) {
    double r = 1.0 + lumpy * noise3(lobes, 1.7 * d) + 0.4 * lumpy * noise3(lobes, 4.0 * d);
    if (m.level == 0) r += 0.03 * relief(d);
    const Point3 p = r * d;
    return Point3{p.x + lean * p.z, p.y, p.z > -0.2 ? p.z : -0.2 + 0.1 * (p.z + 0.2)};
  };
  const auto colour = [&](Point3 d) {
    const double up = std::clamp(0.5 + 0.6 * d.z, 0.0, 1.0);
    const double dying = std::clamp(4.0 * (0.5 + 0.5 * noise3(death, 2.0 * d) - 1.15 * m.health), 0.0, 1.0);
    const Tone c = mix(mix(groove, live, m.level == 0 ? relief(d) : 0.55), dead, dying);
    return (0.45 + 0.6 * up) * c;
  };
  ThingBuilder builder;
  builder.blob(m.by_level(3, 2, 0), place, colour);
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

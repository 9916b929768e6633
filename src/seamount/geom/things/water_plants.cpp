// Seagrass and kelp: straps and blades that lean with the water.
#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {
namespace {

Tone ailing(Tone live, double health) { return mix(tone(0x9A8A62), live, health); }

}  // namespace

ThingMesh make_seagrass(const ThingMaking& m) {
  Rng rng(m.seed.derive("blades"));
  const Tone live = ailing(m.main(0x66743F), m.health);
  const int blades = m.by_level(120, 44, 13), steps = m.by_level(5, 3, 1);
  ThingBuilder builder;
  for (int i = 0; i < blades; ++i) {
    const double out = std::sqrt((i + 0.5) / blades), bearing = 2.39996 * i + rng.uniform(-0.6, 0.6);
    const Point3 foot{0.62 * out * std::cos(bearing), 0.62 * out * std::sin(bearing), 0.0};
    const double tall = rng.uniform(0.55, 1.0) * (1.05 - 0.25 * out), lot = rng.uniform();
    const double sway = rng.uniform(0.15, 0.55), face = rng.uniform(0.0, 6.28), shade = rng.uniform(0.8, 1.2);
    const double wide = m.by_level(0.022, 0.04, 0.09) * rng.uniform(0.8, 1.2);
    const Point3 drift = unit(Point3{1.0, 0.0, 0.0} + 0.8 * direction(bearing, 0.0));
    const Point3 across{std::cos(face), std::sin(face), 0.0};
    const auto place = [&](double u, double v) {
      const double taper = v > 0.75 ? std::max(0.12, 1.0 - 3.4 * (v - 0.75)) : 1.0;
      return foot + (tall * sway * v * v) * drift + Point3{0.0, 0.0, tall * v * (1.0 - 0.25 * sway * v)} +
             (wide * taper * (u - 0.5)) * across;
    };
    builder.missing(!m.has(lot, 0.3));
    builder.sheet(
        1, steps, place, [&](double, double v) { return ((0.40 + 0.6 * v) * shade) * live; }, {0.0, 0.0, 1.0}, 0.55);
  }
  return builder.finish(m.height_m, m.width_m);
}

ThingMesh make_kelp(const ThingMaking& m) {
  Rng rng(m.seed.derive("stipes"));
  const Tone live = ailing(m.main(0x6E6136), m.health), stem = 0.7 * live;
  const int stipes = m.by_level(5, 4, 3), rings = m.by_level(14, 7, 2), blades = m.by_level(34, 14, 3);
  ThingBuilder builder;
  for (int i = 0; i < stipes; ++i) {
    const double bearing = 2.39996 * i, tall = i == 0 ? 1.0 : rng.uniform(0.65, 0.98), phase = rng.uniform(0.0, 6.28);
    const double lot = rng.uniform();
    Rng own(m.seed.derive("stipe", static_cast<uint64_t>(i)));
    const auto stipe = [&](double t) {
      return Point3{0.10 * t * std::cos(bearing) + 0.12 * t * t + 0.025 * std::sin(phase + 7.0 * t),
                    0.10 * t * std::sin(bearing) + 0.025 * std::sin(phase + 5.0 * t), tall * t};
    };
    const bool whole = i == 0 || m.has(lot, 0.3);
    std::vector<Ring3> line;
    line.reserve(static_cast<size_t>(rings));
    for (int k = 0; k < rings; ++k) line.push_back({stipe(static_cast<double>(k) / (rings - 1)), 0.0045, stem});
    builder.missing(!whole);
    builder.tube(line, 3);
    for (int k = 0; k < blades; ++k) {
      const double t = 0.06 + 0.94 * (k + 0.5) / blades, turn = 2.39996 * k + phase, fate = own.uniform();
      const double reach = (0.10 + 0.04 * own.uniform()) * m.by_level(1.0, 1.25, 2.4);
      const Point3 out = direction(turn, 0.35), base = stipe(t);
      const Point3 tip = base + reach * unit(out + Point3{0.55, 0.0, 0.1});
      builder.missing(!whole || !m.has(fate, 0.3));
      const Point3 side = unit(cross(tip - base, Point3{0.0, 0.0, 1.0}));
      builder.leaf(base, tip, (0.17 * reach) * unit(side + Point3{0.0, 0.0, 0.7}),
                   unit(Point3{0.0, 0.0, 1.0} + 0.6 * out), (0.5 + 0.3 * t) * live, own.uniform(0.85, 1.15) * live);
    }
  }
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

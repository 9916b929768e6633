#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/geom/things/coral_tone.h"
#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {

ThingMesh make_sponge(const ThingMaking& m) {
  // Outer wall, lip and inner wall of a tube: radius and height.
  constexpr std::array<std::array<double, 2>, 7> kFine = {
      {{0.62, 0.0}, {0.85, 0.3}, {1.0, 0.65}, {0.92, 0.95}, {0.74, 1.0}, {0.62, 0.9}, {0.5, 0.45}}};
  constexpr std::array<std::array<double, 2>, 3> kCoarse = {{{0.65, 0.0}, {1.0, 0.7}, {0.8, 1.0}}};
  Rng rng(m.seed.derive("tubes"));
  const Seed wave = m.seed.derive("wave");
  const Tone live = colony_tone(m, 0x85695A, 0.2);
  const int tubes = m.by_level(6, 4, 2), sectors = m.by_level(16, 8, 6);
  const int rows = m.level < 2 ? 7 : 3;
  ThingBuilder builder;
  for (int i = 0; i < tubes; ++i) {
    const double out = i == 0 ? 0.0 : rng.uniform(0.28, 0.42), bearing = 2.39996 * i + rng.uniform(-0.4, 0.4);
    const double tall = (i == 0 ? 1.0 : rng.uniform(0.45, 0.9)), wide = 0.17 * (0.6 + 0.5 * tall);
    const double lot = rng.uniform(), lean = rng.uniform(0.1, 0.3);
    const Point3 foot{out * std::cos(bearing), out * std::sin(bearing), 0.0};
    const Point3 tip = foot + tall * Point3{lean * std::cos(bearing), lean * std::sin(bearing), 1.0};
    builder.missing(i > 0 && !m.has(lot, 0.3));
    const auto place = [&](int row, double angle) {
      const auto [r, h] = m.level < 2 ? kFine[static_cast<size_t>(row)] : kCoarse[static_cast<size_t>(row)];
      const Point3 axis = mix(foot, tip, h);
      const double knobs = 1.0 + 0.12 * noise3(wave, {5.0 * std::cos(angle) + 7.0 * i, 5.0 * std::sin(angle), 6.0 * h});
      return axis + (wide * r * knobs) * Point3{std::cos(angle), std::sin(angle), 0.0};
    };
    const Point3 floor = mix(foot, tip, m.level < 2 ? 0.35 : 0.9);
    const auto colour = [&](Point3 p) {
      const double h = std::clamp((p.z - foot.z) / tall, 0.0, 1.0);
      const Point3 axis = mix(foot, tip, h);
      const bool inside = std::hypot(p.x - axis.x, p.y - axis.y) < 0.7 * wide && h > 0.3 && h < 0.96;
      return (inside ? 0.22 : 0.55 + 0.45 * h) * live;
    };
    builder.lathe(foot - Point3{0.0, 0.0, 0.02}, floor, rows, sectors, place, colour);
  }
  builder.missing(false);
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/geom/things/coral_tone.h"
#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {
namespace {

/// A plate as a closed lens with a wavy rim; height of its upper side over (x, y) and its outline.
struct Plate {
  Seed seed;
  double size = 1.0, tilt_x = 0.0, tilt_y = 0.0;
  Point3 middle;

  double rim(double angle) const {
    return size * (1.0 + 0.13 * noise3(seed, {2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.5}) +
                   0.06 * noise3(seed, {6.0 * std::cos(angle), 6.0 * std::sin(angle), 3.5}));
  }
  Point3 at(double share, double angle, double below) const {
    const double r = share * rim(angle), x = r * std::cos(angle), y = r * std::sin(angle);
    const double bowl = 0.10 * share * share * size + 0.02 * noise3(seed, {4.0 * x, 4.0 * y, 7.0});
    return middle + Point3{x, y, bowl + tilt_x * x + tilt_y * y - below * (1.0 - 0.75 * share)};
  }
};

void add_plate(ThingBuilder& builder, const ThingMaking& m, const Plate& plate, Tone live) {
  const int sectors = m.by_level(26, 12, 6), rows = m.by_level(4, 2, 1);
  const double thick = 0.085 * plate.size;
  const Tone under = 0.42 * live, rim = mix(live, bleached(tone(0xD9CDA8), m.health), 0.45);
  const auto place = [&](int row, double angle) {
    if (row < rows) return plate.at((row + 1.0) / rows, angle, thick);
    return plate.at((2.0 * rows - row - 0.04) / (rows + 0.0) * 0.98, angle, 0.0);
  };
  const auto colour = [&](Point3 p) {
    const double flat = std::hypot(p.x - plate.middle.x, p.y - plate.middle.y) / plate.size;
    const bool top = p.z > plate.at(std::min(flat, 1.0), std::atan2(p.y, p.x), 0.3 * thick).z;
    return top ? mix(live, rim, std::clamp(3.5 * (flat - 0.72), 0.0, 1.0)) : under;
  };
  builder.lathe(plate.at(0.0, 0.0, thick), plate.at(0.0, 0.0, 0.0), 2 * rows, sectors, place, colour);
}

void add_branchlets(ThingBuilder& builder, const ThingMaking& m, const Plate& plate, Tone live, int count) {
  Rng rng(m.seed.derive("branchlets"));
  const Tone tip = mix(live, bleached(tone(0xD9CDA8), m.health), 0.55);
  for (int i = 0; i < count; ++i) {
    const double share = std::sqrt((i + 0.5) / count), angle = 2.39996 * i + rng.uniform(-0.2, 0.2);
    const double reach = plate.size * rng.uniform(0.045, 0.085), lot = rng.uniform(), turn = rng.uniform(0.0, 2.0);
    const Point3 base = plate.at(0.98 * share, angle, 0.01);
    const Point3 out{std::cos(angle), std::sin(angle), 0.0};
    const Point3 along = unit(Point3{0.0, 0.0, 1.0} + (0.9 * share * share + rng.uniform(-0.3, 0.3)) * out);
    builder.missing(!m.has(lot, 0.25));
    builder.spike(base, base + reach * along, 0.034 * plate.size, turn, 0.62 * live, tip);
  }
  builder.missing(false);
}

}  // namespace

ThingMesh make_table_coral(const ThingMaking& m) {
  Rng rng(m.seed.derive("form"));
  const Tone live = colony_tone(m, 0x7F7350);
  ThingBuilder builder;
  Plate plate{m.seed.derive("plate"), 1.0, rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), {0.0, 0.0, 0.40}};
  plate.middle.x = rng.uniform(-0.12, 0.12);
  const std::vector<Ring3> stalk = {{{0.0, 0.0, 0.0}, 0.24, 0.45 * live},
                                    {{0.3 * plate.middle.x, 0.0, 0.16}, 0.15, 0.4 * live},
                                    {{0.9 * plate.middle.x, 0.0, 0.30}, 0.32, 0.4 * live},
                                    {{0.95 * plate.middle.x, 0.0, 0.34}, 0.04, 0.4 * live}};
  builder.tube(stalk, m.by_level(10, 6, 3));
  add_plate(builder, m, plate, live);
  if (m.level < 2) add_branchlets(builder, m, plate, live, m.by_level(240, 36, 0));
  if (m.level < 2 && rng.chance(0.5)) {  // a smaller plate that grew over the first
    Plate upper{m.seed.derive("upper"), rng.uniform(0.4, 0.6), 0.0, 0.0, {rng.uniform(-0.3, 0.3), 0.2, 0.56}};
    add_plate(builder, m, upper, live);
  }
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

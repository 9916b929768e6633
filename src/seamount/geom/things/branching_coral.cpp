#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/geom/things/coral_tone.h"
#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {
namespace {

struct Branch {
  Point3 from, along;
  double length, radius, lot;
  int fork;  ///< forks that are still to come
};

class Staghorn {
 public:
  explicit Staghorn(const ThingMaking& m)
      : m_(m), live_(colony_tone(m, 0x8E7650)), tip_(bleached(mix(live_, tone(0xE9DFC6), 0.7), m.health)) {}

  ThingMesh make() {
    Rng rng(m_.seed.derive("stems"));
    const int stems = m_.by_level(10, 7, 8);
    const double turn = rng.uniform(0.0, 6.28);
    for (int i = 0; i < stems; ++i) {
      const double out = std::sqrt((i + 0.5) / stems);  // from the middle to the rim
      const double bearing = turn + 2.39996 * i + rng.uniform(-0.3, 0.3);
      const double height = 1.45 - 1.05 * out + rng.uniform(-0.12, 0.12);
      const Point3 foot{0.20 * out * std::cos(bearing), 0.20 * out * std::sin(bearing), 0.0};
      const double reach = rng.uniform(0.46, 0.62) * (1.0 + 0.15 * out);
      grow({foot, direction(bearing, height), reach, 0.055, rng.uniform(), m_.by_level(2, 1, 0)}, rng, true);
    }
    return builder_.finish(m_.height_m, m_.width_m);
  }

 private:
  void grow(const Branch& b, Rng& rng, bool alive) {
    const bool whole = alive && m_.has(b.lot, 0.45);
    constexpr double kStump = 0.45;
    const Point3 curl = unit(b.along + Point3{0.0, 0.0, 0.35});
    const Point3 middle = b.from + (0.5 * b.length) * b.along, end = middle + (0.5 * b.length) * curl;
    builder_.missing(!whole);
    draw(b, middle, end, true);
    builder_.missing(false);
    if (alive && !whole) draw(b, mix(b.from, middle, kStump), mix(b.from, middle, 2.0 * kStump), false);
    if (b.fork == 0) return;
    const int forks = b.fork == 2 ? 3 : 2;
    const double turn = rng.uniform(0.0, 6.28);
    const Point3 u = beside(curl), v = cross(curl, u);
    for (int k = 0; k < forks; ++k) {
      const double angle = turn + 2.0 * std::numbers::pi * k / forks + rng.uniform(-0.4, 0.4);
      const double at = rng.uniform(0.45, 0.95), open = rng.uniform(0.55, 0.9);
      Point3 along = unit(curl + open * (std::cos(angle) * u + std::sin(angle) * v));
      along = unit({along.x, along.y, std::max(along.z, 0.12) + 0.2});
      const Point3 from = at < 0.5 ? mix(b.from, middle, 2.0 * at) : mix(middle, end, 2.0 * at - 1.0);
      grow({from, along, b.length * rng.uniform(0.45, 0.68), 0.72 * b.radius, rng.uniform(), b.fork - 1}, rng, whole);
    }
  }

  void draw(const Branch& b, Point3 middle, Point3 end, bool whole) {
    const auto shade = [&](Point3 p) {
      const double outer = std::clamp(1.6 * length({p.x, p.y, 0.9 * p.z}), 0.0, 1.0);
      return 0.42 + 0.58 * outer;  // little light comes in between the stems
    };
    const Tone foot = shade(b.from) * live_, half = shade(middle) * live_;
    const Tone top = whole ? tip_ : shade(end) * mix(live_, tone(0xD8D0C0), 0.5);
    if (m_.level == 2) {
      builder_.spike(b.from, end, 1.7 * b.radius, b.lot, foot, mix(half, top, 0.5));
      return;
    }
    const std::vector<Ring3> rings = {
        {b.from, b.radius, foot}, {middle, 0.88 * b.radius, half}, {end, (whole ? 0.42 : 0.7) * b.radius, top}};
    builder_.tube(rings, b.radius > 0.05 && m_.level == 0 ? 4 : 3);
  }

  const ThingMaking& m_;
  Tone live_, tip_;
  ThingBuilder builder_;
};

}  // namespace

ThingMesh make_branching_coral(const ThingMaking& making) { return Staghorn(making).make(); }

}  // namespace seamount::geom

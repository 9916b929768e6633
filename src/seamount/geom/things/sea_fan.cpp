#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/things/coral_tone.h"
#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {
namespace {

class Fan {
 public:
  explicit Fan(const ThingMaking& m) : m_(m), live_(colony_tone(m, 0x6B4C58)), rng_(m.seed.derive("branches")) {}

  ThingMesh make() {
    grow({0.0, 0.0, 0.0}, 0.0, 0.16, 0.020, m_.by_level(6, 4, 2), true);
    return builder_.finish(m_.height_m, m_.width_m);
  }

 private:
  void grow(Point3 from, double lean, double reach, double radius, int forks, bool alive) {
    const Point3 end = from + reach * Point3{std::sin(lean), 0.10 * rng_.uniform(-1.0, 1.0), std::cos(lean)};
    const double lot = rng_.uniform();
    alive = alive && (from == Point3{} || m_.has(lot, 0.8));
    builder_.missing(!alive);
    const double outer = std::clamp(0.55 + 0.35 * end.z, 0.0, 1.0);
    const std::vector<Ring3> rings = {{from, radius, outer * live_}, {end, 0.7 * radius, outer * live_}};
    if (m_.level == 2) {
      builder_.spike(from, end + 0.25 * (end - from), 2.4 * radius, 0.0, outer * live_, live_);
    } else {
      builder_.tube(rings, 3);
    }
    if (forks == 0) return;
    const double open = rng_.uniform(0.30, 0.55);
    for (const double side : {-1.0, 1.0}) {
      const double next = std::clamp(lean + side * open + rng_.uniform(-0.15, 0.15), -1.7, 1.7);
      grow(end, next, reach * rng_.uniform(0.80, 1.0), 0.80 * radius, forks - 1, alive);
    }
    if (forks > 4 && rng_.chance(0.4)) {
      grow(end, lean + rng_.uniform(-0.15, 0.15), 0.8 * reach, 0.7 * radius, forks - 2, alive);
    }
  }

  const ThingMaking& m_;
  Tone live_;
  Rng rng_;
  ThingBuilder builder_;
};

}  // namespace

ThingMesh make_sea_fan(const ThingMaking& making) { return Fan(making).make(); }

}  // namespace seamount::geom

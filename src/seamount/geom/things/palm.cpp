#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {
namespace {

struct Frond {
  Point3 base, out;  ///< level direction
  double rise;       ///< angle at which it starts
  double reach, sag, age;

  Point3 at(double t) const {
    const double ahead = reach * (t - 0.16 * t * t) * std::cos(rise) + 0.05 * reach * t;
    return base + ahead * out + Point3{0.0, 0.0, reach * (std::sin(rise) * t - sag * t * t)};
  }
};

class Palm {
 public:
  explicit Palm(const ThingMaking& m) : m_(m), green_(m.main(0x5F7038)), dry_(tone(0x8E7B4E)) {}

  ThingMesh make() {
    Rng rng(m_.seed.derive("form"));
    top_ = trunk(rng);
    const int fronds = m_.by_level(24, 13, 7);
    for (int i = 0; i < fronds; ++i) add_frond(i, fronds, rng);
    if (m_.level == 0) add_nuts(rng);
    return builder_.finish(m_.height_m, m_.width_m);
  }

 private:
  /// A trunk that leaves the ground aslant and straightens up; its top.
  Point3 trunk(Rng& rng) {
    const double lean = rng.uniform(0.03, 0.24), bearing = rng.uniform(0.0, 6.28), wobble = rng.uniform(-0.05, 0.05);
    const int rings = m_.by_level(11, 6, 3), sides = m_.by_level(8, 5, 3);
    std::vector<Ring3> trunk;
    Point3 at;
    for (int i = 0; i < rings; ++i) {
      const double t = static_cast<double>(i) / (rings - 1), bow = lean * (1.6 * t - 0.7 * t * t) * 0.62;
      at = Point3{bow * std::cos(bearing) + wobble * std::sin(3.0 * t), bow * std::sin(bearing), t};
      const double radius = 0.0105 + 0.0095 * std::pow(1.0 - t, 3.0) + (i % 2 == 0 ? 0.0008 : 0.0);
      trunk.push_back({at, radius, (i % 2 == 0 ? 0.85 : 1.0) * mix(tone(0x75695A), tone(0x8C8070), t)});
    }
    builder_.tube(trunk, sides);
    // The crown's middle comes over the foot: a leaning palm is as wide as its crown and its lean.
    return at;
  }

  void add_frond(int i, int count, Rng& rng) {
    const double age = (i + 0.5) / count;  // 0 the youngest, upright
    const double bearing = 2.39996 * i + rng.uniform(-0.25, 0.25);
    const Frond frond{top_,
                      {std::cos(bearing), std::sin(bearing), 0.0},
                      1.2 - 1.55 * age + rng.uniform(-0.1, 0.1),
                      0.27 * rng.uniform(0.88, 1.08),
                      0.30 + 0.30 * age * (1.0 - 0.4 * age),
                      age};
    const double lot = rng.uniform();
    builder_.missing(!m_.has(lot, 0.35));
    const double dryness = std::clamp(1.5 * (age - 0.72) + 1.1 * (1.0 - m_.health), 0.0, 1.0);
    Tone green = mix(green_, dry_, dryness);
    green = rng.uniform(0.85, 1.15) * green;
    m_.level == 0 ? feathered(frond, green, rng) : plain(frond, green);
    builder_.missing(false);
  }

  /// A midrib with leaflets that hang from it.
  void feathered(const Frond& f, Tone green, Rng& rng) {
    const Point3 across{-f.out.y, f.out.x, 0.0};
    constexpr int kLeaflets = 22;
    builder_.sheet(
        1, 5, [&](double u, double v) { return f.at(v) + ((u - 0.5) * 0.006 * (1.1 - v)) * across; },
        [&](double, double) { return 0.8 * mix(green, dry_, 0.5); }, {0.0, 0.0, 1.0}, 0.7);
    for (int k = 0; k < kLeaflets; ++k) {
      const double t = 0.12 + 0.86 * (k + 0.5) / kLeaflets;
      const double reach = 0.30 * f.reach * std::sin(3.0 * std::pow(t, 0.8)) + 0.03;
      const Point3 base = f.at(t), along = unit(f.at(t + 0.03) - f.at(t - 0.03));
      for (const double side : {-1.0, 1.0}) {
        const double hang = 0.45 + 0.5 * f.age + rng.uniform(-0.12, 0.12);
        const Point3 way = unit(0.55 * along + side * across - Point3{0.0, 0.0, hang});
        const Point3 outward = unit((1.0 / f.reach) * (base - top_) + Point3{0.0, 0.0, 0.8} + 0.25 * side * across);
        builder_.blade(base, base + reach * way, 0.0072 * along, outward, 0.7 * green, 1.1 * green);
      }
    }
  }

  /// Two half blades in a roof.
  void plain(const Frond& f, Tone green) {
    const Point3 across{-f.out.y, f.out.x, 0.0};
    const int along = m_.by_level(5, 4, 1);
    for (const double side : {-1.0, 1.0}) {
      if (m_.level == 2 && side < 0.0) continue;
      builder_.sheet(
          1, along,
          [&](double u, double v) {
            const double wide =
                (m_.level == 2 ? 0.16 : 0.20) * f.reach * std::sin(0.25 + 2.7 * std::clamp(v, 0.0, 1.0));
            const double s = m_.level == 2 ? 2.0 * u - 1.0 : side * u;
            return f.at(v) + (wide * s) * across - Point3{0.0, 0.0, 0.55 * wide * std::abs(s)};
          },
          [&](double u, double) { return (0.9 - 0.15 * u) * green; }, unit(f.out + Point3{0.0, 0.0, 1.4}), 0.6);
    }
  }

  void add_nuts(Rng& rng) {
    for (int i = 0; i < 4; ++i) {
      const Point3 at = top_ + 0.017 * direction(rng.uniform(0.0, 6.28), -0.5) - Point3{0.0, 0.0, 0.012};
      builder_.blob(
          0, [&](Point3 d) { return at + 0.0085 * d; }, [](Point3) { return tone(0x6E6238); });
    }
  }

  const ThingMaking& m_;
  Tone green_, dry_;
  Point3 top_;
  ThingBuilder builder_;
};

}  // namespace

ThingMesh make_palm(const ThingMaking& making) { return Palm(making).make(); }

}  // namespace seamount::geom

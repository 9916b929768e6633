#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {
namespace {

struct Form {
  double bare, wide, droop, power;
  /// Reach of the branches at a height of the stem.
  double reach(double z) const { return wide * std::pow(std::max(0.0, (1.0 - z) / (1.0 - bare)), power); }
};

/// A branch as a spray that hangs from its rib, with sprigs to both sides.
void add_spray(ThingBuilder& builder, const Form& form, double z, double bearing, double reach, Tone green, Rng& rng) {
  const Point3 out{std::cos(bearing), std::sin(bearing), 0.0}, across{-out.y, out.x, 0.0};
  const double rise = rng.uniform(-0.05, 0.15) + 0.5 * std::pow(z, 3.0);
  const auto rib = [&](double t) {
    return Point3{0.0, 0.0, z} + (reach * t) * out +
           Point3{0.0, 0.0, reach * (rise * t - form.droop * t * t + 0.12 * t * t * t)};
  };
  constexpr int kSprigs = 4;
  const Point3 lean = unit(out + Point3{0.0, 0.0, 1.1});
  for (int k = 0; k < kSprigs; ++k) {
    const double t = 0.22 + 0.78 * k / kSprigs, wide = 0.42 * reach * (1.05 - 0.75 * t);
    const Point3 base = rib(t - 0.12);
    for (const double side : {-1.0, 1.0}) {
      const Point3 tip = rib(std::min(1.05, t + 0.22)) + (side * wide) * across - Point3{0.0, 0.0, 0.42 * wide};
      builder.blade(base, tip, 0.075 * reach * unit(out + 0.6 * side * across), unit(lean + 0.35 * side * across),
                    0.42 * green, rng.uniform(0.85, 1.15) * green);
    }
  }
  builder.blade(rib(0.55), rib(1.12), (0.09 * reach) * across, lean, 0.6 * green, 1.1 * green);
}

/// Cones over one another.
void add_tiers(ThingBuilder& builder, const ThingMaking& m, const Form& form, Tone green, Seed wave) {
  const int tiers = m.by_level(0, 8, 2), sectors = m.by_level(0, 9, 5);
  for (int i = 0; i < tiers; ++i) {
    const double low = form.bare + (1.0 - form.bare) * i / tiers;
    const double high = std::min(1.0, low + 1.75 * (1.0 - form.bare) / tiers);
    const double r = form.reach(low);
    builder.lathe(
        {0.0, 0.0, low + 0.25 * (high - low)}, {0.0, 0.0, high}, 1, sectors,
        [&](int, double angle) {
          const double ragged = 1.0 + 0.30 * noise3(wave, {2.7 * std::cos(angle), 2.7 * std::sin(angle), 9.0 * low});
          return Point3{r * ragged * std::cos(angle + 0.7 * i), r * ragged * std::sin(angle + 0.7 * i), low};
        },
        [&](Point3 p) {
          const bool rim = std::hypot(p.x, p.y) > 0.3 * r;
          return (rim ? 0.95 : p.z >= high - 1e-9 ? 0.9 : 0.30) * green;
        });
  }
}

}  // namespace

ThingMesh make_conifer(const ThingMaking& m) {
  Rng rng(m.seed.derive("form"));
  const Form form{rng.uniform(0.05, 0.14), 0.5, rng.uniform(0.28, 0.5), rng.uniform(0.75, 0.95)};
  const Tone bark = tone(0x5C4F43);
  const Tone live = rng.uniform(0.85, 1.15) * mix(m.main(0x3F4E35), tone(0x556042), rng.uniform(0.0, 0.5));
  const Tone green = mix(live, tone(0x7A6248), 0.85 * (1.0 - m.health));
  ThingBuilder builder;
  const double top = m.level == 0 ? 0.97 : 0.7;
  const std::vector<Ring3> stem = {
      {{}, 0.032, 0.8 * bark}, {{0.0, 0.0, 0.5 * top}, 0.017, bark}, {{0.0, 0.0, top}, 0.004, bark}};
  builder.tube(stem, m.by_level(6, 4, 3));
  const Seed wave = m.seed.derive("wave");
  if (m.level > 0) {
    add_tiers(builder, m, form, green, wave);
    return builder.finish(m.height_m, m.width_m);
  }
  constexpr int kWhorls = 19;
  for (int i = 0; i < kWhorls; ++i) {
    const double z = form.bare + (0.985 - form.bare) * std::pow(static_cast<double>(i) / kWhorls, 0.92);
    const int branches = std::max(5, 9 - i / 4);
    for (int k = 0; k < branches; ++k) {
      const double bearing = 6.28319 * k / branches + 1.3 * i + rng.uniform(-0.25, 0.25), lot = rng.uniform();
      const double reach = std::max(0.045, form.reach(z) * rng.uniform(0.78, 1.08)),
                   jitter = rng.uniform(-0.012, 0.012);
      Rng own(wave.derive("branch", static_cast<uint64_t>(16 * i + k)));
      builder.missing(!m.has(lot, 0.25));
      add_spray(builder, form, z + jitter, bearing, reach, own.uniform(0.85, 1.12) * green, own);
    }
  }
  builder.missing(false);
  builder.spike({0.0, 0.0, 0.94}, {0.0, 0.0, 1.0}, 0.018, 0.0, 0.7 * green, green);
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

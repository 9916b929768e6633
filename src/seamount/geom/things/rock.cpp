// A boulder is what joint planes leave of a ball: its radius is a p-norm of the planes' distances, which rounds the
// edges.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/geom/things/makers.h"
#include "seamount/geom/things/thing_builder.h"

namespace seamount::geom {
namespace {

struct Joint {
  Point3 normal;
  double distance;
};

std::vector<Joint> joints(Seed seed, int count) {
  Rng rng(seed.derive("joints"));
  std::vector<Joint> all;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / count, bearing = 2.4 * i + rng.uniform(-0.7, 0.7);
    const double flat = std::sqrt(std::max(0.0, 1.0 - z * z));
    const Point3 normal{flat * std::cos(bearing), flat * std::sin(bearing), z + rng.uniform(-0.2, 0.2)};
    all.push_back({unit(normal), rng.uniform(0.72, 1.1)});
  }
  return all;
}

double radius(const std::vector<Joint>& all, Point3 direction, double sharpness) {
  double sum = 0.0;
  for (const Joint& joint : all)
    sum += std::pow(std::max(0.0, dot(direction, joint.normal) / joint.distance), sharpness);
  return std::pow(std::max(sum, 1e-6), -1.0 / sharpness);
}

/// Ground hides what is below; the foot is nearly flat.
Point3 flattened(Point3 p, double low) { return p.z >= low ? p : Point3{p.x, p.y, low + 0.12 * (p.z - low)}; }

struct RockKind {
  int joints;
  double sharpness, rough;
  unsigned rgb, dark;
};

ThingMesh make(const ThingMaking& m, const RockKind& kind, int fineness) {
  const std::vector<Joint> all = joints(m.seed, kind.joints);
  const Seed grain = m.seed.derive("grain");
  Rng rng(m.seed.derive("form"));
  const double turn = rng.uniform(0.0, 2.0 * std::numbers::pi), squeeze = rng.uniform(0.72, 1.0);
  const double warm = rng.uniform(-0.06, 0.06), light = rng.uniform(0.85, 1.12);
  const auto shape = [&](Point3 d) {
    const double noise = 0.55 * noise3(grain, 2.3 * d) + 0.3 * noise3(grain, 5.1 * d) + 0.2 * noise3(grain, 11.0 * d);
    const double r = radius(all, d, kind.sharpness) * (1.0 + kind.rough * noise);
    const Point3 p = flattened(r * d, -0.42);
    const double x = p.x, y = squeeze * p.y;
    return Point3{std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, p.z};
  };
  const Tone main = m.main(kind.rgb), dark = mix(main, tone(kind.dark), 0.8);
  const auto colour = [&](Point3 d) {
    const double stain = 0.5 + 0.5 * noise3(grain, 3.1 * d + Point3{9.0, 0.0, 0.0});
    const double crack = std::clamp(-1.6 * noise3(grain, 5.1 * d), 0.0, 1.0);
    Tone c = mix(main, dark, 0.45 * stain + 0.45 * crack);
    c.r *= 1.0 + warm;
    c.b *= 1.0 - warm;
    const double contact = 0.62 + 0.38 * std::clamp((d.z + 0.5) / 0.6, 0.0, 1.0);
    return (light * contact) * c;
  };
  ThingBuilder builder;
  builder.blob(fineness, shape, colour);
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace

ThingMesh make_rock(const ThingMaking& m) { return make(m, {13, 16.0, 0.10, 0x8F8A82, 0x544F4B}, m.by_level(3, 2, 0)); }

ThingMesh make_pebble(const ThingMaking& m) { return make(m, {9, 4.0, 0.03, 0x9B948A, 0x6F685F}, m.by_level(3, 2, 0)); }

}  // namespace seamount::geom

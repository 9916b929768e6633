// Broadleaf trees, shrubs and mangroves: limbs, and clusters of leaves at their ends.
#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/things/crown.h"

namespace seamount::geom {
namespace {

/// Clusters that fill an ellipsoid: one on top, the others around in rings.
std::vector<Cluster> crown_clusters(int count, Point3 middle, double wide, double tall, double size, Rng& rng) {
  std::vector<Cluster> all;
  for (int i = 0; i < count; ++i) {
    const double z = 0.95 - 1.55 * (i + 0.3) / count, flat = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double bearing = 2.39996 * i + rng.uniform(-0.4, 0.4), out = rng.uniform(0.52, 0.82);
    const Point3 at = middle + Point3{wide * flat * out * std::cos(bearing), wide * flat * out * std::sin(bearing),
                                      tall * z * rng.uniform(0.55, 0.8)};
    all.push_back({at, size * rng.uniform(0.75, 1.2), rng.uniform(0.68, 0.86), rng.uniform()});
  }
  return all;
}

void add_tree_limbs(ThingBuilder& builder, const ThingMaking& m, const std::vector<Cluster>& clusters, Point3 fork,
                    double radius, Tone bark) {
  if (m.level == 2) return;
  for (const Cluster& c : clusters) {
    const Point3 bend{0.0, 0.0, -0.12 * length(c.centre - fork)};
    add_limb(builder, fork - Point3{0.0, 0.0, radius}, c.centre, 0.5 * radius, 0.12 * radius, 3, bark, bend);
  }
}

}  // namespace

ThingMesh make_broadleaf(const ThingMaking& m) {
  Rng rng(m.seed.derive("form"));
  const double first = rng.uniform(0.26, 0.36), radius = rng.uniform(0.022, 0.03);
  const Point3 fork{rng.uniform(-0.04, 0.04), rng.uniform(-0.04, 0.04), first};
  const Tone bark = tone(0x6A5E50);
  ThingBuilder builder;
  add_limb(builder, {}, fork, 1.35 * radius, 0.85 * radius, m.by_level(7, 5, 3), bark,
           {rng.uniform(-0.015, 0.015), rng.uniform(-0.015, 0.015), 0.0});
  const Point3 middle = fork + Point3{0.0, 0.0, 0.5 * (1.0 - first)};
  const auto clusters = crown_clusters(m.by_level(11, 9, 9), middle, 0.36, 0.44, 0.165, rng);
  add_tree_limbs(builder, m, clusters, fork, radius, bark);
  const Tone leaf = rng.uniform(0.85, 1.15) * mix(m.main(0x526236), tone(0x6B7A3A), rng.uniform(0.0, 0.45));
  add_crown(builder, m, {leaf, tone(0x8A7A4C), middle - Point3{0.0, 0.0, 0.1}, 1.0, first, 1150, 0.036}, clusters);
  return builder.finish(m.height_m, m.width_m);
}

ThingMesh make_shrub(const ThingMaking& m) {
  Rng rng(m.seed.derive("form"));
  const Tone bark = tone(0x6E6150);
  ThingBuilder builder;
  const Point3 middle{0.0, 0.0, 0.35};
  const auto clusters = crown_clusters(m.by_level(9, 7, 7), middle, 0.62, 0.62, 0.30, rng);
  add_limb(builder, {}, {0.0, 0.0, 0.3}, 0.035, 0.02, m.by_level(5, 3, 3), bark);
  add_tree_limbs(builder, m, clusters, {0.0, 0.0, 0.10}, 0.045, bark);
  const Tone leaf = rng.uniform(0.85, 1.15) * mix(m.main(0x5D6A40), tone(0x7B7548), rng.uniform(0.0, 0.5));
  add_crown(builder, m, {leaf, tone(0x8F8058), {0.0, 0.0, 0.15}, 0.9, 0.0, 1150, 0.055}, clusters);
  return builder.finish(m.height_m, m.width_m);
}

ThingMesh make_mangrove(const ThingMaking& m) {
  Rng rng(m.seed.derive("form"));
  const Tone bark = tone(0x6B5C50);
  const Point3 collar{0.0, 0.0, rng.uniform(0.30, 0.38)}, fork{0.0, 0.0, 0.55};
  ThingBuilder builder;
  add_limb(builder, collar - Point3{0.0, 0.0, 0.03}, fork, 0.03, 0.026, m.by_level(6, 4, 3), bark);
  const int roots = m.by_level(12, 7, 3);
  for (int i = 0; i < roots; ++i) {
    const double bearing = 2.39996 * i + rng.uniform(-0.3, 0.3), out = rng.uniform(0.16, 0.34);
    const Point3 from = collar + Point3{0.0, 0.0, rng.uniform(-0.05, 0.08)};
    const Point3 foot{out * std::cos(bearing), out * std::sin(bearing), 0.0};
    if (m.level == 2) {
      builder.spike(foot, from, 0.012, 0.0, bark, bark);
      continue;
    }
    add_limb(builder, from, foot, 0.013, 0.010, m.by_level(4, 3, 3), 0.9 * bark,
             {0.22 * foot.x, 0.22 * foot.y, 0.07});  // the root arches
  }
  const Point3 middle{0.0, 0.0, 0.72};
  const auto clusters = crown_clusters(m.by_level(10, 7, 7), middle, 0.46, 0.26, 0.18, rng);
  add_tree_limbs(builder, m, clusters, fork, 0.03, bark);
  const Tone leaf = rng.uniform(0.9, 1.1) * m.main(0x4B5C36);
  add_crown(builder, m, {leaf, tone(0x84784C), middle - Point3{0.0, 0.0, 0.1}, 1.0, 0.42, 950, 0.036}, clusters);
  return builder.finish(m.height_m, m.width_m);
}

}  // namespace seamount::geom

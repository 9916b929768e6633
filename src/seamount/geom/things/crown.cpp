#include "seamount/geom/things/crown.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace seamount::geom {
namespace {

/// Light that comes into a crown: less below and inside.
double openness(const CrownStyle& s, Point3 p, double outer) {
  const double height = std::clamp((p.z - s.bottom) / std::max(1e-6, s.top - s.bottom), 0.0, 1.0);
  return (0.42 + 0.58 * height) * (0.55 + 0.45 * outer);
}

void add_leaves(ThingBuilder& builder, const ThingMaking& m, const CrownStyle& s, const Cluster& c, int count,
                double size, bool alive, Rng& rng) {
  const double clump = rng.uniform(0.84, 1.16);
  for (int i = 0; i < count; ++i) {
    const Point3 d = unit({rng.normal(), rng.normal(), rng.normal() + 0.25});
    const double r = c.radius * rng.uniform(0.72, 1.08), lot = rng.uniform(), shade = rng.uniform(0.82, 1.18);
    const Point3 at = c.centre + Point3{r * d.x, r * d.y, c.flat * r * d.z};
    const Point3 any = unit({rng.normal(), rng.normal(), rng.normal()});
    const Point3 normal = unit(d + 0.7 * unit(at - s.middle) + 0.25 * any);
    const Point3 facing = unit(d + 0.9 * any);
    const Point3 along = unit(cross(facing, any)), side = cross(facing, along);
    const double l = size * rng.uniform(0.75, 1.3);
    builder.missing(!alive || !m.has(lot, 0.12));
    const Tone live = mix(s.leaf, s.autumn, std::clamp(0.9 * (1.0 - m.health) + 0.25 * (shade - 1.0), 0.0, 1.0));
    const Tone tone = (clump * shade * openness(s, at, r / c.radius)) * live;
    builder.blade(at - l * along, at + l * along, (0.75 * l) * side, normal, 0.88 * tone, tone);
  }
  builder.missing(false);
}

void add_core(ThingBuilder& builder, const ThingMaking& m, const CrownStyle& s, const Cluster& c, double share,
              double light, uint64_t number) {
  const Seed wave = m.seed.derive("core", number);
  builder.blob(
      0,
      [&](Point3 d) {
        const double r = share * c.radius * (1.0 + 0.25 * noise3(wave, 2.5 * d));
        return c.centre + Point3{r * d.x, r * d.y, c.flat * r * d.z};
      },
      [&](Point3 d) {
        const Tone leaf = mix(s.leaf, s.autumn, 0.9 * (1.0 - m.health));
        return (light * openness(s, c.centre + (share * c.radius) * d, 0.5 + 0.5 * d.z)) * leaf;
      });
}

/// One cluster around several.
Cluster around(const std::vector<Cluster>& all, size_t begin, size_t end) {
  Cluster sum{{}, 0.0, 0.0, 1.0};
  double weight = 0.0;
  for (size_t i = begin; i < end; ++i) {
    const double w = all[i].radius * all[i].radius;
    sum.centre = sum.centre + w * all[i].centre;
    sum.flat += w * all[i].flat;
    sum.lot = std::min(sum.lot, all[i].lot);
    weight += w;
  }
  sum.centre = (1.0 / weight) * sum.centre;
  sum.flat /= weight;
  for (size_t i = begin; i < end; ++i)
    sum.radius = std::max(sum.radius, 0.85 * (length(all[i].centre - sum.centre) + all[i].radius));
  return sum;
}

}  // namespace

void add_crown(ThingBuilder& builder, const ThingMaking& m, const CrownStyle& s, const std::vector<Cluster>& clusters) {
  double area = 0.0;
  for (const Cluster& c : clusters) area += c.radius * c.radius;
  if (m.level == 2) {
    const size_t groups = std::min<size_t>(2, clusters.size());
    for (size_t g = 0; g < groups; ++g) {
      const Cluster c = around(clusters, g * clusters.size() / groups, (g + 1) * clusters.size() / groups);
      builder.missing(g > 0 && !m.has(c.lot, 0.25));
      add_core(builder, m, s, c, 1.0, 1.0, g);
    }
    builder.missing(false);
    return;
  }
  for (size_t i = 0; i < clusters.size(); ++i) {
    const Cluster& c = clusters[i];
    const bool alive = m.has(c.lot, 0.25);
    Rng rng(m.seed.derive("leaves", i));
    const double share = c.radius * c.radius / area;
    const auto count = static_cast<int>(std::lround(share * m.by_level(s.leaves, s.leaves / 7, 0)));
    builder.missing(!alive || m.health <= 0.35);
    add_core(builder, m, s, c, m.by_level(0.60, 0.84, 1.0), m.by_level(0.50, 0.85, 1.0), i);
    add_leaves(builder, m, s, c, count, m.by_level(s.leaf_size, 1.7 * s.leaf_size, 0.0), alive, rng);
  }
}

void add_limb(ThingBuilder& builder, Point3 from, Point3 to, double radius, double end_radius, int sides, Tone bark,
              Point3 bend) {
  const std::array<Ring3, 3> rings = {{{from, radius, 0.75 * bark},
                                       {mix(from, to, 0.5) + bend, 0.5 * (radius + end_radius), 0.9 * bark},
                                       {to, end_radius, bark}}};
  builder.tube(rings, sides);
}

}  // namespace seamount::geom

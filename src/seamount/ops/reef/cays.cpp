#include "seamount/ops/reef/cays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/geom/scalar/blend.h"
#include "seamount/ops/reef/blob.h"

namespace seamount::reef {
namespace {

constexpr double kBeach_m = 25.0;  // from the water half way to the top of a cay

struct Site {
  double score = 0.0;
  Vec2 place;
  double room_m = 0.0;  ///< of flat around it
};

/// Places on flats, each with how well sand gathers there: in the lee of a broad reef.
std::vector<Site> sites_of(const CayRules& rules, const ScalarField& distance, const ScalarField& lagoon,
                           const ScalarField& exposure, const ScalarField& crowding, Vec2 to_swell, Seed seed) {
  const GridFrame& f = distance.frame();
  const int step = std::max(1, static_cast<int>(0.5 * rules.radius_m / f.cell_m));
  std::vector<Site> sites;
  for (int y = 0; y < f.height; y += step) {
    for (int x = 0; x < f.width; x += step) {
      const double in = distance(x, y), room = std::min(in, -static_cast<double>(lagoon(x, y)));
      if (room < 0.45 * rules.radius_m || in > 4.0 * rules.radius_m) continue;
      const Vec2 place{f.x(x), f.y(y)}, ahead = place + 2.5 * rules.radius_m * to_swell;
      const int ax = static_cast<int>(std::lround(f.column(ahead.x))),
                ay = static_cast<int>(std::lround(f.row(ahead.y)));
      Rng rng(seed.derive("reef.cay",
                          static_cast<uint64_t>(y) * static_cast<uint64_t>(f.width) + static_cast<uint64_t>(x)));
      const double lee = -static_cast<double>(exposure(x, y));
      if (lee < 0.15) continue;
      const double broad = crowding.clamped(ax, ay);
      sites.push_back({lee + 1.2 * broad + 0.7 * rng.uniform(), place, room});
    }
  }
  std::stable_sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) { return a.score > b.score; });
  return sites;
}

}  // namespace

ScalarField make_cays(const CayRules& rules, const ScalarField& distance, const ScalarField& lagoon,
                      const ScalarField& exposure, const ScalarField& crowding, Seed seed) {
  const double angle = rules.swell_from_deg * std::numbers::pi / 180.0;
  const Vec2 to_swell{std::sin(angle), std::cos(angle)};
  const double apart = 8.0 * rules.radius_m;
  ScalarField cays(distance.frame(), 0.0F);
  std::vector<Vec2> placed;
  for (const Site& site : sites_of(rules, distance, lagoon, exposure, crowding, to_swell, seed)) {
    if (static_cast<int>(placed.size()) >= rules.count) break;
    const Vec2 c = site.place;
    if (std::any_of(placed.begin(), placed.end(), [&](Vec2 o) { return dot(o - c, o - c) < apart * apart; })) continue;
    Rng rng(seed.derive("reef.cay_shape", placed.size()));
    placed.push_back(c);
    // As long as the flat allows: a few large ones, many small.
    const double longest = std::min(400.0, 1.5 * site.room_m + 40.0);
    const double along = std::max(45.0, longest * (0.25 + 0.75 * rng.uniform() * rng.uniform(0.3, 1.0))),
                 flatness = rng.uniform(0.38, 0.7);
    const double half_width = along * flatness;
    const double top = half_width > 50.0 ? rng.uniform(0.88, 1.0) : rng.uniform(0.6, 0.66);
    const double bearing = angle + (90.0 + rng.uniform(-40, 40)) * std::numbers::pi / 180.0;
    const double beach = std::max(std::min(kBeach_m, 0.7 * half_width), 1.5 * cays.cell_m());
    const Blob blob(c, along, flatness, bearing, rng);
    blob.for_each_cell(cays.frame(), [&](int x, int y, double inside_m) {
      float& z = cays(x, y);
      z = std::max(z, static_cast<float>(top * geom::smoothstep(0.5 * inside_m / beach + 0.05)));
    });
  }
  return placed.empty() ? ScalarField() : cays;
}

}  // namespace seamount::reef

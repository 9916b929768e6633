#include "seamount/geom/water/follow_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/water/inland.h"

namespace seamount::geom {
namespace {

constexpr double kBeachShare = 0.95;  // of the beach that lies within its width and height
constexpr float kLowestBeach_m = 1.0F;

bool of_land(Region region) { return region == Region::mountain || region == Region::beach; }

Grid<uint8_t> find_sea(const HeightField& terrain, float sea_m, const RunContext& run) {
  const Grid<uint8_t> hollows = find_hollows(terrain, sea_m, std::nullopt, run);
  Grid<uint8_t> sea(terrain.frame());
  for (size_t i = 0; i < sea.size(); ++i)
    sea.data()[i] = terrain.data()[i] <= sea_m && (hollows.empty() || hollows.data()[i] == 0) ? 1 : 0;
  return sea;
}

/// A terrain with its sea and how far each cell lies from it.
struct Shore {
  const HeightField& terrain;
  Grid<uint8_t> sea;
  ScalarField away;

  Shore(const HeightField& heights, float sea_m, const RunContext& run)
      : terrain(heights), sea(find_sea(heights, sea_m, run)), away(distance_to(sea, run)) {}
};

/// Where a beach can be: near the sea and low.
struct BeachZone {
  float width_m = 0, top_m = 0;

  bool has(const Shore& shore, size_t cell) const {
    return shore.away.data()[cell] <= width_m && shore.terrain.data()[cell] <= top_m;
  }
};

float most_of(std::vector<float> values) {
  const auto at = values.begin() + static_cast<ptrdiff_t>(kBeachShare * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// As the beaches are; without beaches nowhere.
BeachZone zone_of(const LabelMap& labels, const Shore& before, float sea_m) {
  std::vector<float> away, heights;
  for (size_t i = 0; i < labels.size(); ++i) {
    if (labels.data()[i] != Region::beach || before.sea.data()[i] != 0 || !std::isfinite(before.away.data()[i]))
      continue;
    away.push_back(before.away.data()[i]);
    heights.push_back(before.terrain.data()[i]);
  }
  if (away.empty()) return {-1.0F, sea_m};
  return {most_of(std::move(away)), std::max(most_of(std::move(heights)), sea_m + kLowestBeach_m)};
}

/// What drowned becomes: the nearest water that was water, but land lies in a lagoon behind a reef.
LabelMap waters(const LabelMap& labels, const Grid<uint8_t>& sea, const RunContext& run) {
  Grid<uint8_t> known(labels.frame());
  bool any = false;
  for (size_t i = 0; i < known.size(); ++i) {
    known.data()[i] = sea.data()[i] != 0 && !of_land(labels.data()[i]) ? 1 : 0;
    any = any || known.data()[i] != 0;
  }
  LabelMap made(labels.frame(), Region::abyss);
  if (!any) return made;
  Grid<int32_t> nearest(labels.frame());
  nearest_feature(known, nearest, run);
  for (size_t i = 0; i < made.size(); ++i)
    if (labels.data()[nearest.data()[i]] != Region::abyss) made.data()[i] = Region::lagoon;
  return made;
}

}  // namespace

LabelMap follow_labels(const LabelMap& labels, const HeightField& before, const HeightField& after, float sea_m,
                       const RunContext& run) {
  const Shore then(before, sea_m, run), now(after, sea_m, run);
  const BeachZone zone = zone_of(labels, then, sea_m);
  const LabelMap drowned = waters(labels, now.sea, run);
  LabelMap made = labels;
  for (size_t i = 0; i < made.size(); ++i) {
    Region& region = made.data()[i];
    if (now.sea.data()[i] != 0) {
      if (of_land(region)) region = drowned.data()[i];
      continue;
    }
    const bool in_zone = zone.has(now, i);
    if (of_land(region) && then.sea.data()[i] == 0 && in_zone == zone.has(then, i)) continue;
    region = in_zone ? Region::beach : Region::mountain;
  }
  return made;
}

LabelMap plain_labels(const HeightField& terrain, float sea_m, const RunContext& run) {
  const Grid<uint8_t> sea = find_sea(terrain, sea_m, run);
  LabelMap made(terrain.frame(), Region::mountain);
  for (size_t i = 0; i < made.size(); ++i)
    if (sea.data()[i] != 0) made.data()[i] = Region::abyss;
  return made;
}

}  // namespace seamount::geom

#include "seamount/ops/contour/refine/refine_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/polygon/poisson_disc.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/convert/reconstruct.h"

namespace seamount::contour {
namespace {

constexpr double kGap = 5.0;               ///< between held contours, in spacings of the network that is refined
constexpr double kSamplesAcross = 1024.0;  ///< of the ground between contours
constexpr double kLevelsApart = 0.3;       ///< of a level from the height of an outline, in steps between levels

size_t at(int32_t i) { return static_cast<size_t>(i); }

void measure_land(CoarseGround& ground) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const float z : ground.heights) {
    low = std::min(low, z);
    high = std::max(high, z);
  }
  ground.low_m = low;
  ground.high_m = high;
  if (!(low < high)) throw InvalidArgument("tin", "has one height only; there are no contours to hold");
}

/// The height of an outline to which none was given: between the highest node that it keeps out and the lowest that it
/// keeps in, or the other way round for a basin.
std::vector<double> outline_heights(const Tin& tin) {
  const size_t count = tin.regions.size();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> below(count, -kFar), above(count, kFar);
  const auto enter = [&](int32_t inner, int32_t outer, double inside, double outside) {
    // Every outline from the inner region out that does not hold the outer node too lies between the two.
    for (int32_t r = inner; r >= 0; r = tin.regions[at(r)].parent) {
      for (int32_t o = outer; o >= 0; o = tin.regions[at(o)].parent) {
        if (o == r) return;
      }
      const bool basin = tin.regions[at(r)].basin;
      below[at(r)] = std::max(below[at(r)], basin ? inside : outside);
      above[at(r)] = std::min(above[at(r)], basin ? outside : inside);
    }
  };
  for (const auto& triangle : tin.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const size_t a = at(triangle[k]), b = at(triangle[(k + 1) % 3]);
      if (tin.region[a] == tin.region[b]) continue;
      enter(tin.region[a], tin.region[b], tin.height_m[a], tin.height_m[b]);
      enter(tin.region[b], tin.region[a], tin.height_m[b], tin.height_m[a]);
    }
  }
  std::vector<double> heights(count, 0.0);
  for (size_t r = 0; r < count; ++r) {
    if (std::isfinite(below[r]) && std::isfinite(above[r])) heights[r] = 0.5 * (below[r] + above[r]);
  }
  return heights;
}

/// An outline around the frame and all that goes beyond it.
HeldOutline land_around(const ContourSet& set, double height_m) {
  const GridFrame& frame = set.frame;
  geom::Box all = {{frame.west_m, frame.south_m()}, {frame.east_m(), frame.north_m}};
  for (const Contour& contour : set.contours) {
    for (const Vec2 p : contour.ring) {
      all.low = {std::min(all.low.x, p.x), std::min(all.low.y, p.y)};
      all.high = {std::max(all.high.x, p.x), std::max(all.high.y, p.y)};
    }
  }
  const double m = frame.cell_m;
  const Ring ring = {{all.low.x - m, all.low.y - m},
                     {all.high.x + m, all.low.y - m},
                     {all.high.x + m, all.high.y + m},
                     {all.low.x - m, all.high.y + m}};
  return {{"land", ring, -1, height_m, false, {}}, true};
}

/// Places of the land alone: nodes of the sea lie ever further apart.
void enter_places(const Tin& tin, CoarseGround& ground) {
  double area = 0.0;
  const auto is_land = [&](int32_t node) { return tin.region.empty() || tin.region[at(node)] != Tin::kOutside; };
  for (const auto& [a, b, c] : tin.triangles) {
    const int corners = (is_land(a) ? 1 : 0) + (is_land(b) ? 1 : 0) + (is_land(c) ? 1 : 0);
    area += corners / 6.0 * cross(tin.nodes[at(b)] - tin.nodes[at(a)], tin.nodes[at(c)] - tin.nodes[at(a)]);
  }
  for (size_t node = 0; node < tin.nodes.size(); ++node) {
    if (!is_land(static_cast<int32_t>(node))) continue;
    ground.places.push_back(tin.nodes[node]);
    ground.heights.push_back(tin.height_m[node]);
  }
  ground.place_m2 = area / static_cast<double>(std::max<size_t>(ground.places.size(), 1));
  ground.spacing_m = std::sqrt(geom::kDiscDensity * ground.place_m2);
}

/// Does land reach the frame's edge, so that the ground below the lowest contours belongs to it?
bool reaches_edge(const ContourSet& set) {
  const GridFrame& f = set.frame;
  return std::any_of(set.contours.begin(), set.contours.end(), [&](const Contour& contour) {
    const geom::Box box = geom::bounding_box(contour.ring);
    return box.low.x <= f.west_m || box.high.x >= f.east_m() || box.low.y <= f.south_m() || box.high.y >= f.north_m;
  });
}

/// Enters the contours as outlines, and with them how long they are.
double enter_outlines(const ContourSet& set, CoarseGround& ground, const RunContext& run) {
  double length = 0.0;
  for (GrowthRegion& region : regions_from_contours(set, set.frame, "contours", run).regions) {
    ground.levels.push_back(*region.height_m);
    length += geom::ring_length(region.outline);
    ground.outlines.push_back({std::move(region), true});
  }
  std::sort(ground.levels.begin(), ground.levels.end());
  ground.levels.erase(std::unique(ground.levels.begin(), ground.levels.end()), ground.levels.end());
  return length;
}

/// Mean distance between contours that bound that land.
double mean_gap(const CoarseGround& ground, double length_m) {
  return static_cast<double>(ground.places.size()) * ground.place_m2 / std::max(length_m, ground.spacing_m);
}

std::vector<double> even_levels(const CoarseGround& ground, int count) {
  std::vector<double> levels;
  for (int i = 1; i <= count; ++i) levels.push_back(ground.low_m + (ground.high_m - ground.low_m) * i / (count + 1));
  return levels;
}

/// As many levels as make contours kGap spacings apart.
int level_count(const CoarseGround& ground, const Tin& tin, const RunContext& run) {
  constexpr int kTrial = 10;
  double length = 0.0;
  for (const Contour& contour : geom::march_triangles(tin, even_levels(ground, kTrial), run))
    length += geom::ring_length(contour.ring);
  const double gap = mean_gap(ground, length);
  return static_cast<int>(std::lround(std::clamp(kTrial * gap / (kGap * ground.spacing_m), 3.0, 30.0)));
}

/// Heights halfway between those that are held, where there is room.
std::vector<double> halfway_levels(const CoarseGround& ground) {
  double length = 0.0;
  for (const HeldOutline& outline : ground.outlines) length += geom::ring_length(outline.region.outline);
  if (mean_gap(ground, length) < 0.7 * kGap * ground.spacing_m) return {};
  std::vector<double> ends = ground.levels, levels;
  ends.insert(ends.begin(), ground.low_m);
  ends.push_back(ground.high_m);
  for (size_t i = 1; i < ends.size(); ++i) levels.push_back(0.5 * (ends[i - 1] + ends[i]));
  return levels;
}

}  // namespace

CoarseGround ground_of(const Tin& tin) {
  if (tin.nodes.empty() || tin.triangles.empty()) throw InvalidArgument("tin", "has no triangles");
  if (tin.height_m.empty()) throw InvalidArgument("tin", "has no heights yet; give it some with contour.heights");
  CoarseGround ground;
  ground.frame = tin.frame;
  enter_places(tin, ground);
  measure_land(ground);
  if (tin.regions.empty()) {
    ground.outlines.push_back(land_around({tin.frame, {}}, ground.low_m));
    return ground;
  }
  const std::vector<double> heights = outline_heights(tin);
  RegionTree tree = regions_of(tin);
  for (size_t i = 0; i < tree.regions.size(); ++i) {
    GrowthRegion& region = tree.regions[i];
    region.height_m = region.height_m.value_or(static_cast<double>(static_cast<float>(heights[i])));
    if (region.parent < 0) ground.low_m = std::min(ground.low_m, *region.height_m);
    ground.outlines.push_back({std::move(region), true});
  }
  return ground;
}

CoarseGround ground_of(const ContourSet& set, const RunContext& run) {
  if (set.contours.empty()) throw InvalidArgument("contours", "holds no contours");
  CoarseGround ground;
  ground.frame = set.frame;
  const double length = enter_outlines(set, ground, run);
  ReconstructParams sampling;
  sampling.cell_m = std::max(set.frame.cell_m, std::max(set.frame.width_m(), set.frame.height_m()) / kSamplesAcross);
  const HeightField field = reconstruct(set, sampling, run);
  const bool all_land = reaches_edge(set);
  for (int y = 0; y < field.height(); ++y) {
    run.check_cancelled();
    for (int x = 0; x < field.width(); ++x) {
      if (!all_land && field(x, y) < static_cast<float>(ground.levels.front())) continue;
      ground.places.push_back({field.frame().x(x), field.frame().y(y)});
      ground.heights.push_back(field(x, y));
    }
  }
  if (ground.places.empty()) throw InvalidArgument("contours", "enclose no cell of the domain");
  measure_land(ground);
  const double step = (ground.high_m - ground.levels.front()) / static_cast<double>(ground.levels.size());
  ground.low_m = std::min(ground.low_m, ground.levels.front() - (all_land ? 0.1 * step : 0.0));
  if (all_land) {
    for (HeldOutline& outline : ground.outlines) ++outline.region.parent;
    ground.outlines.insert(ground.outlines.begin(), land_around(set, ground.low_m));
  }
  const double cell = field.frame().cell_m;
  ground.place_m2 = cell * cell;
  const double area = static_cast<double>(ground.places.size()) * ground.place_m2;
  ground.spacing_m = std::max(0.5 * area / length, 2.0 * set.frame.cell_m);
  return ground;
}

std::vector<double> new_levels(const CoarseGround& ground, const Tin& tin, int count, const RunContext& run) {
  std::vector<double> levels;
  if (!ground.levels.empty()) {
    levels = halfway_levels(ground);
  } else {
    levels = even_levels(ground, count > 0 ? count : level_count(ground, tin, run));
  }
  const double apart = kLevelsApart * (ground.high_m - ground.low_m) / static_cast<double>(levels.size() + 1);
  // Heights of nodes are floats: so that none of them lies beside a level only because it is rounded.
  for (double& level : levels) level = static_cast<double>(static_cast<float>(level));
  std::erase_if(levels, [&](double level) {
    return std::any_of(ground.outlines.begin(), ground.outlines.end(), [&](const HeldOutline& outline) {
      return std::abs(*outline.region.height_m - level) < (ground.levels.empty() ? apart : 0.02 * apart);
    });
  });
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

}  // namespace seamount::contour

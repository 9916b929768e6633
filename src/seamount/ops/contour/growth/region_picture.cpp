// Regions from painted grey levels (regions.h).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "seamount/base/error.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/growth/regions.h"

namespace seamount::contour {
namespace {

constexpr int kLevelGap = 16;        ///< greys between two levels
constexpr int kFlat = 12;            ///< greys that a flat neighbourhood may span (JPEG noise)
constexpr int kMinPatch = 12;        ///< pixels
constexpr int kFan = 3;              ///< pixels between outlines that were painted at the same place
constexpr size_t kMostLevels = 16;   ///< 255 / kLevelGap
constexpr double kTolerance = 0.25;  ///< pixels, of the simplified outlines

using Greys = Grid<uint8_t>;

bool is_flat(const Greys& greys, int x, int y) {
  int low = 255;
  int high = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int g = greys.clamped(x + dx, y + dy);
      low = std::min(low, g);
      high = std::max(high, g);
    }
  }
  return high - low <= kFlat;
}

/// Greys of the levels, ascending: the fullest windows of the histogram of flat pixels, then the next ones that are
/// kLevelGap away from all of those and no slope of theirs: the histogram halves at least between the two.
std::vector<int> find_levels(const Greys& greys, const RunContext& run) {
  std::array<int64_t, 256> count{};
  for (int y = 0; y < greys.height(); ++y) {
    run.check_cancelled();
    for (int x = 0; x < greys.width(); ++x) {
      if (is_flat(greys, x, y)) ++count[greys(x, y)];
    }
  }
  const auto window = [&](int grey) {
    int64_t sum = 0;
    for (int g = std::max(grey - kLevelGap / 4, 0); g <= std::min(grey + kLevelGap / 4, 255); ++g) {
      sum += count[static_cast<size_t>(g)];
    }
    return sum;
  };
  std::array<int, 256> order{};
  std::iota(order.begin(), order.end(), 0);
  std::array<int64_t, 256> weight{};
  for (int g = 0; g < 256; ++g) weight[static_cast<size_t>(g)] = 64 * window(g) + count[static_cast<size_t>(g)];
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return weight[static_cast<size_t>(a)] > weight[static_cast<size_t>(b)]; });
  std::vector<int> levels;
  for (const int grey : order) {
    if (window(grey) < kMinPatch / 2 || levels.size() == kMostLevels) break;
    const bool apart = std::all_of(levels.begin(), levels.end(), [&](int level) {
      if (std::abs(level - grey) < kLevelGap) return false;
      int64_t lowest = window(grey);
      for (int g = std::min(level, grey); g <= std::max(level, grey); ++g) lowest = std::min(lowest, window(g));
      return 2 * lowest <= window(grey);
    });
    if (apart) levels.push_back(grey);
  }
  std::sort(levels.begin(), levels.end());
  return levels;
}

/// Whether greys run into each other, as in a height map, instead of standing for zones: much of what is not as dark as
/// the darkest level belongs to no level.
bool is_gradual(const Greys& greys, const std::vector<int>& levels) {
  constexpr int kNear = kLevelGap / 2;
  constexpr double kMostLost = 0.3, kLeastShare = 0.01;
  size_t beyond = 0, lost = 0;
  for (const uint8_t grey : greys.cells()) {
    if (!levels.empty() && grey <= levels[0] + kNear) continue;
    ++beyond;
    const bool held =
        std::any_of(levels.begin(), levels.end(), [&](int level) { return std::abs(level - grey) <= kNear; });
    lost += held ? 0 : 1;
  }
  return static_cast<double>(beyond) >= kLeastShare * static_cast<double>(greys.size()) &&
         static_cast<double>(lost) > kMostLost * static_cast<double>(beyond);
}

/// Greys of a few zones, evenly from the darkest level (or the darkest pixels) to the lightest pixels.
std::vector<int> even_levels(const Greys& greys, const std::vector<int>& levels) {
  constexpr int kMostZones = 6;
  std::vector<uint8_t> sorted(greys.cells().begin(), greys.cells().end());
  const auto at_share = [&](double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return static_cast<int>(sorted[static_cast<size_t>(place)]);
  };
  const int high = at_share(0.998);
  const int darkest = at_share(0.002);
  const int low = !levels.empty() && levels[0] <= darkest + kLevelGap ? levels[0] : darkest;
  const int zones = std::clamp((high - low) / kLevelGap, 1, kMostZones);
  std::vector<int> even;
  for (int i = 0; i <= zones; ++i) even.push_back(low + (high - low) * i / zones);
  return even;
}

/// Keeps a cell whose eight neighbours are inside; what lies beyond the edge is not.
Greys eroded(const Greys& inside) {
  Greys rows(inside.frame(), 0);
  for (int y = 0; y < inside.height(); ++y) {
    for (int x = 1; x + 1 < inside.width(); ++x) rows(x, y) = inside(x - 1, y) & inside(x, y) & inside(x + 1, y);
  }
  Greys result(inside.frame(), 0);
  for (int y = 1; y + 1 < inside.height(); ++y) {
    for (int x = 0; x < inside.width(); ++x) result(x, y) = rows(x, y - 1) & rows(x, y) & rows(x, y + 1);
  }
  return result;
}

/// Where a pixel's level is at least `level`, with `margin` more pixels on every side that repeat the edge.
Greys at_least_level(const Greys& greys, const std::vector<int>& levels, size_t level, int margin) {
  const double limit = 0.5 * (levels[level - 1] + levels[level]);
  Greys inside(GridFrame{greys.width() + 2 * margin, greys.height() + 2 * margin, 1.0, 0.0, 0.0, {}});
  for (int y = 0; y < inside.height(); ++y) {
    for (int x = 0; x < inside.width(); ++x) {
      inside(x, y) = greys.clamped(x - margin, y - margin) > limit ? 1 : 0;
    }
  }
  return inside;
}

/// The painted levels as regions in pixels: x from the western edge, y from the northern one upwards.
std::vector<GrowthRegion> trace_levels(const Greys& greys, const std::vector<int>& levels, bool darkest_is_land,
                                       const RunContext& run) {
  const int margin = kFan * static_cast<int>(levels.size()) + 2;
  std::vector<GrowthRegion> regions;
  const auto add = [&](Ring ring, std::string name, bool basin) {
    if (std::abs(geom::signed_area(ring)) < kMinPatch) return;
    for (Vec2& p : ring) p = p + Vec2{-static_cast<double>(margin), static_cast<double>(margin)};
    regions.push_back({std::move(name), geom::simplify(ring, kTolerance), -1, std::nullopt, basin});
  };
  if (darkest_is_land) {
    const double w = greys.width() + 2.0 * margin;
    const double h = greys.height() + 2.0 * margin;
    add({{0, -h}, {w, -h}, {w, 0}, {0, 0}}, fmt::format("grey {}", levels[0]), false);
  }
  Greys allowed(GridFrame{greys.width() + 2 * margin, greys.height() + 2 * margin, 1.0, 0.0, 0.0, {}}, 1);
  allowed = eroded(allowed);
  for (size_t level = 1; level < levels.size(); ++level) {
    run.check_cancelled();
    Greys inside = at_least_level(greys, levels, level, margin);
    for (size_t c = 0; c < inside.size(); ++c) inside.cells()[c] &= allowed.cells()[c];
    size_t patch = 0;
    for (const Polygon& polygon : geom::trace_mask(inside, run)) {
      const std::string name = fmt::format("grey {} patch {}", levels[level], patch++);
      add(polygon.outer, name, false);
      for (size_t h = 0; h < polygon.holes.size(); ++h) add(polygon.holes[h], fmt::format("{} hole {}", name, h), true);
    }
    allowed = std::move(inside);
    for (int i = 0; i < kFan; ++i) allowed = eroded(allowed);
  }
  return regions;
}

RegionTree from_greys(const Greys& greys, const GridFrame& place, const GridFrame& domain, bool darkest_is_land,
                      const std::string& field, const RunContext& run) {
  std::vector<int> levels = find_levels(greys, run);
  if (is_gradual(greys, levels)) {
    levels = even_levels(greys, levels);
    run.say(fmt::format("{}: the picture's greys run into each other; it is cut into {} zones, from grey {} to {}",
                        field, levels.size() - 1, levels.front(), levels.back()));
  }
  if (levels.size() < (darkest_is_land ? 1 : 2)) {
    throw InvalidArgument(field, fmt::format("the picture shows {} grey level{}; it needs at least two, the darkest of "
                                             "which is the world outside the regions",
                                             levels.size(), levels.size() == 1 ? "" : "s"));
  }
  std::vector<GrowthRegion> regions = trace_levels(greys, levels, darkest_is_land, run);
  const double wide = place.width_m() / greys.width();
  const double high = place.height_m() / greys.height();
  for (GrowthRegion& region : regions) {
    for (Vec2& p : region.outline) p = {place.west_m + wide * p.x, place.north_m + high * p.y};
  }
  if (regions.empty()) {
    throw InvalidArgument(field, fmt::format("every patch of the picture is smaller than {} pixels", kMinPatch));
  }
  return nest_regions(std::move(regions), domain, field, run);
}

}  // namespace

RegionTree regions_from_image(const Image& image, const GridFrame& domain, const PaintedRegions& painted,
                              const std::string& field, const RunContext& run) {
  if (image.width < 3 || image.height < 3) {
    throw InvalidArgument(field,
                          fmt::format("a picture of {} x {} pixels shows no regions", image.width, image.height));
  }
  Greys greys(GridFrame{image.width, image.height, 1.0, 0.0, 0.0, {}});
  for (int y = 0; y < image.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < image.width; ++x) {
      const uint8_t* p = image.pixel(x, y);
      greys(x, y) = static_cast<uint8_t>((299 * p[0] + 587 * p[1] + 114 * p[2] + 500) / 1000);
    }
  }
  return from_greys(greys, domain, domain, painted.darkest_is_land, field, run);
}

RegionTree regions_from_mask(const ScalarField& mask, const GridFrame& domain, const PaintedRegions& painted,
                             const std::string& field, const RunContext& run) {
  float low = 0.0F;
  float high = 0.0F;
  bool any = false;
  for (const float v : mask.cells()) {
    if (!std::isfinite(v)) continue;
    low = any ? std::min(low, v) : v;
    high = any ? std::max(high, v) : v;
    any = true;
  }
  if (!(high > low)) throw InvalidArgument(field, "the mask has one value everywhere; it shows no regions");
  Greys greys(mask.frame());
  for (size_t c = 0; c < mask.size(); ++c) {
    const float v = std::isfinite(mask.cells()[c]) ? mask.cells()[c] : low;
    greys.cells()[c] = static_cast<uint8_t>(std::lround(255.0F * ((v - low) / (high - low))));
  }
  return from_greys(greys, mask.frame(), domain, painted.darkest_is_land, field, run);
}

}  // namespace seamount::contour

#include "seamount/ops/contour/convert/extract.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/inputs.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/contour/simplify.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::contour {
namespace {

constexpr double kMostLevels = 5000;

std::string metres(double value) { return format_number(std::round(value * 1000.0) / 1000.0) + " m"; }

/// Takes out levels that lie outside the heights by less than a hundredth of the relief, as heights that were rounded
/// or made a little lower would have them, and says so. Throws for one that lies further out, and where none is left.
void drop_just_outside(std::vector<double>& levels, double low, double high, const RunContext& run) {
  constexpr double kShare = 0.01;
  const std::string range = metres(low) + " to " + metres(high);
  std::string dropped;
  for (const double level : levels) {
    const double beyond = std::max(low - level, level - high);
    if (beyond <= 0.0) continue;
    if (beyond > kShare * (high - low))
      throw InvalidArgument("levels_m", metres(level) + " is outside the heights, which are " + range);
    dropped += (dropped.empty() ? "" : ", ") + metres(level);
  }
  if (dropped.empty()) return;
  std::erase_if(levels, [&](double level) { return level < low || level > high; });
  if (levels.empty()) throw InvalidArgument("levels_m", dropped + " is outside the heights, which are " + range);
  run.say("there are no contours at " + dropped + ": just outside the heights, which are " + range);
}

/// The levels that the params ask for, ascending, each once.
std::vector<double> chosen_levels(const ExtractParams& params, double low, double high, const RunContext& run) {
  const std::string range = metres(low) + " to " + metres(high);
  std::vector<double> levels = params.levels_m;
  if (!levels.empty()) {
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    drop_just_outside(levels, low, high, run);
    return levels;
  }
  if (params.interval_m) {
    const double first = std::ceil((low - params.base_m) / *params.interval_m);
    const double last = std::floor((high - params.base_m) / *params.interval_m);
    if (last < first)
      throw InvalidArgument("interval_m", "no multiple of " + metres(*params.interval_m) + " from base_m = " +
                                              metres(params.base_m) + " lies within the heights, which are " + range);
    if (last - first >= kMostLevels)
      throw InvalidArgument("interval_m", metres(*params.interval_m) + " would make " +
                                              format_number(last - first + 1) + " levels of heights from " + range +
                                              "; at most " + format_number(kMostLevels) + " are allowed");
    for (double i = first; i <= last; ++i) levels.push_back(params.base_m + i * *params.interval_m);
    return levels;
  }
  // A flat terrain has one height only.
  const int count = high > low ? params.count : 1;
  for (int i = 0; i < count; ++i) levels.push_back(low + (high - low) * ((i + 0.5) / count));
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

/// Takes out contours that are too small, with all that they enclose. REQUIRES: parents before children.
void drop_small(std::vector<Contour>& contours, const ExtractParams& params, const RunContext& run) {
  if (params.min_area_m2 <= 0.0 && params.min_length_m <= 0.0) return;
  std::vector<Contour> kept;
  std::vector<int> place(contours.size(), -1);
  for (size_t i = 0; i < contours.size(); ++i) {
    run.check_cancelled();
    Contour& contour = contours[i];
    const bool orphan = contour.parent >= 0 && place[static_cast<size_t>(contour.parent)] < 0;
    const bool small = std::abs(geom::signed_area(contour.ring)) < params.min_area_m2 ||
                       geom::ring_length(contour.ring) < params.min_length_m;
    if (orphan || small) continue;
    if (contour.parent >= 0) contour.parent = place[static_cast<size_t>(contour.parent)];
    place[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(contour));
  }
  contours = std::move(kept);
}

struct Known {
  float low, high;
  int64_t voids = 0;
};

Known known_range(const HeightField& terrain) {
  Known known{INFINITY, -INFINITY};
  for (const float z : terrain.cells()) {
    if (std::isinf(z)) throw InvalidArgument("terrain", "has an infinite height");
    if (std::isnan(z)) {
      ++known.voids;
      continue;
    }
    known.low = std::min(known.low, z);
    known.high = std::max(known.high, z);
  }
  if (known.low > known.high) throw InvalidArgument("terrain", "none of its heights is known");
  return known;
}

ContourSet finish(const GridFrame& frame, std::vector<Contour> contours, const ExtractParams& params,
                  const RunContext& run) {
  run.check_cancelled();
  geom::nest_contours(contours, run);
  drop_small(contours, params, run);
  if (params.simplify_m > 0.0) geom::simplify_contours(contours, params.simplify_m, run);
  run.report(1.0);
  return {frame, std::move(contours)};
}

}  // namespace

ContourSet extract(const Tin& tin, const ExtractParams& params, const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  if (tin.nodes.empty() || tin.triangles.empty()) throw InvalidArgument("tin", "has no triangles");
  if (tin.height_m.empty()) throw InvalidArgument("tin", "has no heights yet; give it some with contour.heights");
  const auto [low, high] = std::minmax_element(tin.height_m.begin(), tin.height_m.end());
  const std::vector<double> levels = chosen_levels(params, *low, *high, run);
  return finish(tin.frame, geom::march_triangles(tin, levels, run), params, run);
}

ContourSet extract(const HeightField& terrain, const ExtractParams& params, const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  if (terrain.empty()) throw InvalidArgument("terrain", "has no cells");
  const Known known = known_range(terrain);
  const std::vector<double> levels = chosen_levels(params, known.low, known.high, run);
  if (known.voids == 0) return finish(terrain.frame(), geom::trace_contours(terrain, levels, run), params, run);
  HeightField closed = terrain;
  const float below = known.low - std::max(1.0F, known.high - known.low);
  for (float& z : closed.cells())
    if (std::isnan(z)) z = below;
  return finish(terrain.frame(), geom::trace_contours(closed, levels, run), params, run);
}

ContourSet extract(const Tin* tin, const HeightField* terrain, const ExtractParams& params, const RunContext& run) {
  require_one("tin", tin != nullptr, "terrain", terrain != nullptr);
  return tin != nullptr ? extract(*tin, params, run) : extract(*terrain, params, run);
}

}  // namespace seamount::contour

#include "seamount/ops/contour/refine/held_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "seamount/base/text.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/frame_clipping.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/move/fading.h"
#include "seamount/ops/contour/move/local_nesting.h"
#include "seamount/ops/contour/move/move.h"
#include "seamount/ops/contour/move/roughen.h"
#include "seamount/ops/contour/move/smooth.h"

namespace seamount::contour {
namespace {

constexpr double kSmallest = 4.0;      ///< area of a contour that is worth holding, in squared spacings
constexpr double kClosing = 0.1;       ///< how far contours go on beyond the frame, in spacings
constexpr double kLongestWave = 3.0;   ///< of the detail, in coarse spacings
constexpr double kShortestWave = 2.5;  ///< in fine spacings
constexpr double kAmplitude = 0.25;    ///< in coarse spacings
constexpr double kGain = 0.55;         ///< of an octave over the one before
constexpr double kFade = 2.0;          ///< over which detail ends at what stays, in coarse spacings

/// The contours on their way, in one order.
struct Held {
  ContourSet set;
  std::vector<int> outline;  ///< per contour: which of the outlines it is; -1: one that was found
};

Ring oriented(const HeldOutline& outline) {
  Ring ring = outline.region.outline;
  if (outline.region.basin == (geom::signed_area(ring) > 0.0)) std::reverse(ring.begin(), ring.end());
  return ring;
}

Held close(const std::vector<HeldOutline>& outlines, const std::vector<Contour>& found, const GridFrame& frame,
           double reach_m) {
  std::vector<Ring> rings;
  rings.reserve(outlines.size() + found.size());
  for (const HeldOutline& outline : outlines) rings.push_back(oriented(outline));
  for (const Contour& contour : found) rings.push_back(contour.ring);
  Held held;
  held.set.frame = frame;
  for (geom::ClippedRing& closed : geom::clip_to_frame(rings, frame, reach_m)) {
    const bool given = closed.of < outlines.size();
    const double height = given ? *outlines[closed.of].region.height_m : found[closed.of - outlines.size()].height_m;
    held.set.contours.push_back({height, std::move(closed.ring), -1});
    held.outline.push_back(given ? static_cast<int>(closed.of) : -1);
  }
  return held;
}

void drop(Held& held, const std::vector<char>& gone) {
  size_t kept = 0;
  for (size_t i = 0; i < gone.size(); ++i) {
    if (gone[i] != 0) continue;
    if (kept != i) {
      held.set.contours[kept] = std::move(held.set.contours[i]);
      held.outline[kept] = held.outline[i];
    }
    ++kept;
  }
  held.set.contours.resize(kept);
  held.outline.resize(kept);
}

/// Contours that meet an outline, or one another beyond the frame.
void drop_crossing(Held& held, const RunContext& run) {
  std::vector<Contour>& contours = held.set.contours;
  std::vector<geom::Box> boxes;
  std::vector<MovedContour> all;
  for (size_t i = 0; i < contours.size(); ++i) {
    boxes.push_back(geom::bounding_box(contours[i].ring));
    all.push_back({i, &contours[i].ring, {{0, contours[i].ring.size()}}, false});
  }
  std::vector<char> gone(contours.size(), 0);
  for (const NestingDefect& defect : find_nesting_defects(contours, boxes, all, run)) {
    for (const size_t i : {defect.first, defect.second}) gone[i] = gone[i] != 0 || held.outline[i] < 0 ? 1 : 0;
  }
  drop(held, gone);
}

/// Whether heights do not ascend from the contour's parent to it.
bool contradicts(const Contour& contour, const Contour& parent) {
  const bool hill = geom::is_hill(contour);
  if (hill != geom::is_hill(parent))
    return hill ? contour.height_m > parent.height_m : contour.height_m < parent.height_m;
  return hill ? contour.height_m <= parent.height_m : contour.height_m >= parent.height_m;
}

/// Sets parents. Found contours that lie in no outline or contradict go, one layer a round.
void nest(Held& held, const RunContext& run) {
  for (;;) {
    std::vector<Contour>& contours = held.set.contours;
    const std::vector<int> parents = geom::find_contour_parents(contours, run);
    std::vector<char> gone(contours.size(), 0);
    bool any = false;
    for (size_t i = 0; i < contours.size(); ++i) {
      contours[i].parent = parents[i];
      size_t bad = i;
      if (parents[i] >= 0) {
        if (!contradicts(contours[i], contours[static_cast<size_t>(parents[i])])) continue;
        if (held.outline[i] >= 0) bad = static_cast<size_t>(parents[i]);
      }
      if (held.outline[bad] >= 0) continue;
      gone[bad] = 1;
      any = true;
    }
    if (!any) return;
    drop(held, gone);
  }
}

void drop_small(Held& held, double min_area_m2) {
  std::vector<char> gone;
  for (size_t i = 0; i < held.outline.size(); ++i)
    gone.push_back(held.outline[i] < 0 && std::abs(geom::signed_area(held.set.contours[i].ring)) < min_area_m2);
  drop(held, gone);
}

/// 1 away from what stays and from the frame's edge, 0 there.
ScalarField detail_weight(const GridFrame& domain, const std::vector<Polyline>& fixed, double fade_m,
                          const RunContext& run) {
  const GridFrame frame = fading_frame(domain, fade_m, 2048);
  const ScalarField distance = geom::distance_to_lines(fixed, frame, run);
  const double none = 1.5 * frame.cell_m;  // so that it is 0 at all four cells about a place on a line
  return fading_weight(frame, fade_m, run, [&](int x, int y) { return static_cast<double>(distance(x, y)) - none; });
}

bool stays(const Held& held, const std::vector<HeldOutline>& outlines, size_t i) {
  return held.outline[i] >= 0 && outlines[static_cast<size_t>(held.outline[i])].exact;
}

void add_detail(Held& held, const std::vector<HeldOutline>& outlines, const Detail& detail, Seed seed,
                const RunContext& run) {
  std::vector<size_t> chosen;
  std::vector<Polyline> fixed;
  for (size_t i = 0; i < held.outline.size(); ++i) {
    Ring& ring = held.set.contours[i].ring;
    if (stays(held, outlines, i)) {
      fixed.push_back(ring);
      fixed.back().push_back(ring.front());
    } else {
      run.check_cancelled();
      chosen.push_back(i);
      ring = geom::densify(ring, 0.25 * detail.coarse_m);
    }
  }
  if (chosen.empty()) return;
  smooth_contours(held.set, chosen, {0.75 * detail.coarse_m, 1.0, 2}, run);
  if (detail.roughness == 0.0) return;
  const double fade = kFade * detail.coarse_m;
  const ScalarField weight = detail_weight(held.set.frame, fixed, fade, run);
  const double longest = kLongestWave * detail.coarse_m;
  const int octaves =
      1 + std::max(0, static_cast<int>(std::lround(std::log2(longest / (kShortestWave * detail.fine_m)))));
  const Roughen roughen({kAmplitude * detail.roughness * detail.coarse_m, longest, octaves, kGain}, weight,
                        1.5 / std::max(fade, 2.0 * weight.cell_m()), seed);
  const GridFrame& frame = weight.frame();
  const double edge = 0.15 * roughen.shortest_wavelength_m();
  const PlaneMap map{
      {{frame.west_m, frame.south_m()}, {frame.east_m(), frame.north_m}},
      edge,
      0.1 * edge,
      [](const geom::Box&) { return true; },
      [&](double strength, std::span<Vec2> places, const RunContext& part) { roughen.move(strength, places, part); }};
  move_contours(held.set.contours, map, 1.0, run);
}

}  // namespace

RegionTree hold_contours(const std::vector<HeldOutline>& outlines, const std::vector<Contour>& found,
                         const GridFrame& frame, const Detail& detail, Seed seed, const RunContext& run) {
  run.check_cancelled();
  Held held = close(outlines, found, frame, kClosing * detail.fine_m);
  drop_small(held, kSmallest * detail.fine_m * detail.fine_m);
  run.check_cancelled();
  drop_crossing(held, run);
  nest(held, run);
  run.check_cancelled();
  add_detail(held, outlines, detail, seed, run);
  std::vector<GrowthRegion> regions;
  for (size_t i = 0; i < held.outline.size(); ++i) {
    Contour& contour = held.set.contours[i];
    const bool hill = geom::is_hill(contour);
    GrowthRegion region{fmt::format("contour at {} m", format_number(std::round(contour.height_m * 100.0) / 100.0)),
                        std::move(contour.ring),
                        -1,
                        contour.height_m,
                        !hill,
                        {}};
    if (held.outline[i] >= 0) region.name = outlines[static_cast<size_t>(held.outline[i])].region.name;
    regions.push_back(std::move(region));
  }
  return nest_regions(std::move(regions), frame, "contours", run);
}

}  // namespace seamount::contour

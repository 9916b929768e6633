#include "seamount/ops/contour/edit/fill_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/solve/poisson.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/ops/contour/edit/edit_area.h"
#include "seamount/ops/contour/edit/lattice_heights.h"
#include "seamount/ops/contour/edit/lay_ground.h"
#include "seamount/ops/contour/edit/match.h"
#include "seamount/ops/contour/edit/outflow.h"
#include "seamount/ops/contour/move/places.h"
#include "seamount/ops/contour/move/roughen.h"

namespace seamount::contour {
namespace {

/// Root of the mean square of what a blur over one wavelength takes from the ground outside.
double roughness(const EditArea& area, double wavelength_m, const RunContext& run) {
  ScalarField smooth = area.ground;
  geom::gaussian_blur(smooth, 0.5 * wavelength_m, run);
  double sum = 0.0;
  double count = 0.0;
  for (size_t i = 0; i < smooth.size(); ++i) {
    if (area.inward.cells()[i] > 0.0F) continue;
    const auto off = static_cast<double>(area.ground.cells()[i] - smooth.cells()[i]);
    sum += off * off;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

/// Ground stretched smoothly over the outline, read at places that noise displaces one to one: rough, and as free of
/// basins as it was.
ScalarField stretched(const EditArea& area, const ScalarField& share, double share_slope, double wavelength_m,
                      Seed seed, const RunContext& run) {
  const GridFrame& frame = area.patch.nodes;
  ScalarField smooth = area.ground;
  Grid<uint8_t> fixed(frame, 0);
  for (size_t i = 0; i < smooth.size(); ++i) fixed.cells()[i] = area.inward.cells()[i] <= 0.0F ? 1 : 0;
  geom::solve_laplace(smooth, fixed, run);
  constexpr double kAmplitude = 0.2;
  const Roughen roughen({kAmplitude * wavelength_m, wavelength_m, 5, 0.5}, share, share_slope, seed);
  Polyline places;
  places.reserve(smooth.size());
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) places.push_back({frame.x(x), frame.y(y)});
  roughen.move(1.0, places, run);
  ScalarField heights(frame);
  for (size_t i = 0; i < heights.size(); ++i)
    heights.cells()[i] = geom::sample_bilinear(smooth, frame.column(places[i].x), frame.row(places[i].y));
  return heights;
}

/// Where nothing is to be had to lay: stretched ground, displaced, with noise as rough as the surroundings.
ScalarField noisy_ground(const EditArea& area, const FillTool& tool, Seed seed, const RunContext& run) {
  const GridFrame& frame = area.patch.nodes;
  const double rim = std::max(kSoftRim * half_width(area), 4.0 * frame.cell_m);
  ScalarField share(frame);
  for (size_t i = 0; i < share.size(); ++i)
    share.cells()[i] = static_cast<float>(geom::smoothstep(static_cast<double>(area.inward.cells()[i]) / rim));
  ScalarField heights = stretched(area, share, 1.5 / rim, tool.wavelength_m, seed.derive("stretch"), run);
  const ScalarField noise = geom::fbm_grid(frame, seed.derive("fill"), landforms(tool.wavelength_m, frame.cell_m), run);
  constexpr double kDeviation = 0.35;  // of fbm
  constexpr double kRelief = 0.5;      // the rest comes from the displacement
  const double amplitude = kRelief * tool.relief * roughness(area, tool.wavelength_m, run) / kDeviation;
  for (size_t i = 0; i < heights.size(); ++i)
    heights.cells()[i] += share.cells()[i] * static_cast<float>(amplitude) * noise.cells()[i];
  return heights;
}

/// The whole set but what lies in the outline.
PatchSource set_source(const ContourSet& set, const Polygon& outline, double extent_m, const RunContext& run) {
  constexpr double kCells = 64.0;  // across the outline
  constexpr int kMostCells = 768;
  GridFrame frame = set.frame;
  const double longer = std::max(frame.width_m(), frame.height_m());
  frame.cell_m = std::max({extent_m / kCells, longer / kMostCells, frame.cell_m});
  frame.width = std::max(2, static_cast<int>(set.frame.width_m() / frame.cell_m));
  frame.height = std::max(2, static_cast<int>(set.frame.height_m() / frame.cell_m));
  const double without = height_around(set, outline.outer[0]);
  ScalarField ground = lattice_heights(level_lines(set), frame, min_gap(levels_of(set)), without, run);
  ScalarField room = geom::signed_distance({outline}, frame, run);
  return {std::move(ground), std::move(room), 1.0};
}

PatchSource pattern_source(const Drawing& pattern, double extent_m, const RunContext& run) {
  const Polygon& own = pattern.areas[0].parts[0];
  const geom::Box box = geom::bounding_box(own.outer);
  // Large enough that the outline and what is around it come to lie in it at any turn.
  constexpr double kRoom = 1.6;
  const double narrow = std::min(box.high.x - box.low.x, box.high.y - box.low.y);
  ScalarField ground = pattern_ground(pattern, run);
  ScalarField room = geom::signed_distance({own}, ground.frame(), run);
  for (float& distance : room.cells()) distance = -distance;
  return {std::move(ground), std::move(room), std::max(1.0, kRoom * extent_m / narrow)};
}

/// The chosen ground at the area's nodes, from contours as fine as there are.
ScalarField taken(const EditArea& area, const ContourSet& set, const Drawing* pattern, const Placement& placement,
                  const RunContext& run) {
  const GridFrame& nodes = area.patch.nodes;
  ScalarField source;
  if (pattern != nullptr) {
    source = pattern_ground(*pattern, run);
  } else {
    GridFrame frame = nodes;
    const double reach = std::hypot(nodes.width_m(), nodes.height_m());
    frame.width = frame.height = std::max(2, static_cast<int>(std::ceil(reach / frame.cell_m)));
    const Vec2 middle =
        placement.to_source({0.5 * (nodes.west_m + nodes.east_m()), 0.5 * (nodes.south_m() + nodes.north_m)});
    frame.west_m = middle.x - 0.5 * frame.width_m();
    frame.north_m = middle.y + 0.5 * frame.height_m();
    source = reconstruct(ContourSet{frame, set.contours}, {}, run);
  }
  ScalarField laid(nodes);
  parallel_rows(run, nodes.width, nodes.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < nodes.width; ++x) {
        const Vec2 p = placement.to_source({nodes.x(x), nodes.y(y)});
        laid(x, y) = geom::sample_bicubic(source, source.frame().column(p.x), source.frame().row(p.y));
      }
    }
  });
  return laid;
}

void say_match(const std::string& name, const std::string& source, const Match& match, const RunContext& run) {
  const Placement& placement = match.placement;
  const double angle = std::atan2(placement.turn.y, placement.turn.x) * 180.0 / std::numbers::pi;
  run.say(name + " (fill): took the ground at " + place_text(placement.from) + " of " + source + ", turned by " +
          format_number(std::round(angle)) + " degrees" + (placement.mirrored ? ", mirrored" : "") +
          (placement.scale != 1.0 ? ", " + format_number(std::round(placement.scale * 100.0) / 100.0) + " times as wide"
                                  : "") +
          "; along the outline it is " + format_number(std::round(match.misfit_m)) + " m off");
}

}  // namespace

geom::Fbm landforms(double wavelength_m, double cell_m) {
  return {.wavelength_m = wavelength_m, .octaves = 6, .gain = 0.5, .lacunarity = 2.0, .cell_m = 2.0 * cell_m};
}

void fill_polygon(const Polygon& outline, const FillTool& tool, const std::vector<LibraryPattern>& library,
                  ContourSet& set, const std::string& name, Seed seed, const RunContext& run) {
  const EditArea area = make_edit_area(set, outline, false, surroundings(outline), name, run);
  const auto [lowest, highest] = std::minmax_element(area.ground.cells().begin(), area.ground.cells().end());
  if (*lowest == *highest)
    return run.say(name + " (fill): no contour comes near the outline; the ground there stays level");
  const geom::Box box = geom::bounding_box(outline.outer);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  std::vector<PatchSource> sources;
  sources.reserve(library.size() + 1);
  for (const LibraryPattern& pattern : library) sources.push_back(pattern_source(pattern.pattern, extent, run));
  if (library.empty()) sources.push_back(set_source(set, outline, extent, run));
  const ScalarField expected = close_ground(area, run);
  const auto best = [&] { return find_match(area.ground, expected, outline, sources, seed.derive("match"), run); };
  std::optional<Match> match = best();
  // A large outline leaves no room beside it: smaller pieces are enlarged.
  for (double scale = 1.5; !match && library.empty() && scale < 5.0; scale *= 1.5) {
    sources[0].scale = scale;
    match = best();
  }
  ScalarField heights;
  if (match) {
    const LibraryPattern* from = library.empty() ? nullptr : &library[match->source];
    say_match(name, from != nullptr ? from->name : "these contours", *match, run);
    ScalarField laid = taken(area, set, from != nullptr ? &from->pattern : nullptr, match->placement, run);
    const auto relief = static_cast<float>(tool.relief * match->placement.scale);
    for (float& height : laid.cells()) height *= relief;
    heights = lay_ground(area, laid, 0.0, kSoftRim * half_width(area), run);
  } else {
    run.say(name + " (fill): nothing has room for the outline; made of noise as rough as the ground about");
    heights = noisy_ground(area, tool, seed, run);
  }
  const double gap = min_gap(levels_of(set));
  const std::vector<Pond> cut = let_water_out(area, heights, gap, run);
  say_ponds(name + " (fill)", cut, find_ponds(area, heights, gap, run), run);
  replace_area(set, area, heights, name, run);
}

}  // namespace seamount::contour

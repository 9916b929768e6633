// Outlines of regions that are fitted to a field (P3 sec. 1.5.2, eq. 1.32-1.33; Chan and Vese 2001): islands, lagoons,
// beaches, forests.
//
// An outline of length l around an area a minimises
//   E = alpha_i * (evenness + rigidity)             see elastic_line.h
//     - lambda_1 / A * integral of Gamma / g inside   high Gamma attracts, as of curves (eq. 1.32 prints no minus)
//     - lambda_2 / u * integral of Gamma / g along the outline
//     + alpha_s * ((A - a) / (0.05 A))^2              only with a target area A
// with u the circumference of a circle of area A; without a target, A and u are those that the outline comes with.
// With one, the integrals are means over what the outline holds (1 / a, 1 / l), so that what is the same everywhere
// does not swell it. Numbers near 1 whatever the world's size, Gamma's unit and the number of vertices, as in snake.h.
//
// Gamma is sampled once on a raster around each region and read bilinearly; its integral over the inside is one around
// the outline of its integrals along rows (Green), so a step costs its vertices and not its area.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/skeleton/field.h"
#include "seamount/model/skeleton.h"

namespace seamount::geom {

struct RegionOptions {
  double internal = 1.0;   ///< alpha_i, >= 0
  double inside = 1.0;     ///< lambda_1, any sign
  double border = 0.0;     ///< lambda_2, any sign
  double shape = 1.0;      ///< alpha_s, >= 0
  double bend_m = 0.0;     ///< radius below which bends are dear, >= 0; 0: u / 60
  double spacing_m = 0.0;  ///< distance of vertices, >= 0, taken between u / 10 000 and u / 8; 0: u / 96
  double raster_m = 0.0;   ///< cell of the raster, >= 0; 0: u / 128. What is finer in Gamma is not seen;
                           ///< no raster grows beyond 4 million samples, nor its region then
  /// g, >= 0; 0: twice Gamma's deviation over the raster as it is first sampled. Give it where regions are fitted again
  /// and again.
  double field_unit = 0.0;
  int steps = 150;           ///< at most, once the area is there; growing takes some more, >= 0
  double least_gain = 1e-4;  ///< a region rests when three steps on end lower its energy by less than this each, >= 0
};

struct RegionSeed {
  Vec2 at;
  double area_m2 = 0.0;  ///< A, > 0
};

/// An outline to be fitted, of three vertices or more, in either direction.
struct RegionOutlineToFit {
  Skeleton skeleton;
  double area_m2 = 0.0;  ///< A, >= 0; 0: no target, E_shape is left off
};

struct RegionFit {
  Skeleton skeleton;  ///< simple and counter-clockwise; without points where a seed finds no room
  double area_m2 = 0.0;
  double mean_field = 0.0;  ///< of Gamma inside
  struct Step {
    double before, after;
  };
  std::vector<Step> steps;  ///< energies of each step, falling; between steps vertices may be spread anew
  bool rests = false;       ///< false: more steps would lower the energy further
};

/// Grows a region from a disc around each seed towards its area, by a quarter of what it has at a time, each time
/// fitted. It stays smaller where unfit places or its own outline leave no room. Every sample of the raster around its
/// outline is fit, so it keeps up to a cell away from unfit places.
///
/// Throws InvalidArgument for options out of range. Field: about 4000 places a region for the square of side 3 sqrt(A /
/// pi), more as its outline leaves that, in one call for all and a few more. Parallel over regions; time about 1000
/// times the vertices of a region, linear but for log factors.
std::vector<RegionFit> grow_regions(std::span<const RegionSeed> seeds, const RegionOptions& options,
                                    const FieldAtPlaces& field, const RunContext& run);

/// Fits given outlines: vertices are spread evenly between those that are held, then all move and the area grows or
/// shrinks to its target. A vertex with hold 1 never moves, one with hold h takes 1 - h of every step. An outline that
/// crosses itself comes back as it is; vertices on unfit places may leave them, none goes there.
/// Throws InvalidArgument, also for fewer than three points or places that are not finite. Cost as above.
std::vector<RegionFit> fit_regions(std::span<const RegionOutlineToFit> outlines, const RegionOptions& options,
                                   const FieldAtPlaces& field, const RunContext& run);

}  // namespace seamount::geom

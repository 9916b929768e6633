// Maximal Poisson-disc sampling of areas: random points that keep a least distance and leave no room for another one.
//
// Darts are thrown at a shrinking list of squares (Ebeida, Mitchell, Patney, Davidson and Owens 2012): what a disc
// covers whole is dropped, what is left over is split, down to single lattice points, so that the result is maximal on
// the lattice. Tiles of 32 x 32 cells are filled side by side in four turns, such that tiles of one turn do not touch,
// from random numbers of their own: the same points on any number of threads.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/lattice_points.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {

struct DiscSampling {
  Lattice lattice;
  std::vector<LatticePoint> points;  ///< in spatial_order

  /// Least distance of two points in units of the lattice: spacing_m = kSpacing * lattice.unit_m.
  static constexpr int32_t kSpacing = 5793;
};

/// Points per area of one squared spacing: the jamming limit of discs thrown at random.
inline constexpr double kDiscDensity = 0.6965;

/// Largest side of the box over the spacing.
inline constexpr double kMostDiscsAcross = 90000.0;

/// Points at least spacing_m apart over the parts of `box` that lie in one of the areas or nearer than margin_m to one
/// (and a little beyond, by whole cells of 0.7 spacings); each place there has a point nearer than spacing_m. REQUIRES:
/// spacing_m > 0, margin_m >= 0, box sides in (0, kMostDiscsAcross spacing_m), finite rings. Parallel; about 0.3 us and
/// 30 bytes per point, and a byte per 32 x 32 cells of the box.
DiscSampling poisson_discs(const std::vector<Polygon>& areas, double margin_m, const Box& box, double spacing_m,
                           Seed seed, const RunContext& run);

}  // namespace seamount::geom

// The contours that a pass of contour.refine grows between: outlines that are held as they are, and contours taken from
// a coarse network, which are polygons of its triangles until they are given the detail that it could not have.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/growth/regions.h"

namespace seamount::contour {

/// Detail is added between these wavelengths.
struct Detail {
  double coarse_m = 0.0;   ///< spacing of the network that the contours come from
  double fine_m = 0.0;     ///< the finest spacing that they will be grown in
  double roughness = 1.0;  ///< displacement, in quarters of coarse_m
};

/// A region whose outline has a height, and whether it stays as it is.
struct HeldOutline {
  GrowthRegion region;
  bool exact = true;
};

/// Joins contours to outlines and gives detail to all that need not stay: they are smoothed over the coarse network's
/// edges and displaced by one common field of noise that ends at what stays. Left out are contours that cross an
/// outline, lie in none, contradict heights around them, or are smaller than a few discs. All rings are closed along
/// the frame's edge. Outlines nest as before, and heights ascend. About n log n in the points that come about.
RegionTree hold_contours(const std::vector<HeldOutline>& outlines, const std::vector<Contour>& found,
                         const GridFrame& frame, const Detail& detail, Seed seed, const RunContext& run);

}  // namespace seamount::contour

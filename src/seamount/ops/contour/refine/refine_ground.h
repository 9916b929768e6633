// The ground that a pass of contour.refine starts from, and which contours of it are held.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/refine/held_contours.h"

namespace seamount::contour {

/// A ground, of land alone, as heights at places that stand for equal areas, with the outlines and levels of it that
/// are held.
struct CoarseGround {
  GridFrame frame;
  double spacing_m = 0.0;  ///< of its nodes, or of ones that would show as much
  double place_m2 = 0.0;   ///< that a place stands for
  std::vector<Vec2> places;
  std::vector<float> heights;  ///< of the places
  std::vector<HeldOutline> outlines;
  std::vector<double> levels;  ///< heights that have contours among the outlines, ascending
  double low_m = 0.0;          ///< of the land
  double high_m = 0.0;
};

/// The ground of a network; outlines without a height get the one that they have in it. One without regions is bounded
/// by its frame. Throws InvalidArgument for a network without triangles or heights, or of one height.
CoarseGround ground_of(const Tin& tin);

/// The ground of a set, as contour.reconstruct makes it; where land reaches the frame's edge, all of it is land. Throws
/// InvalidArgument for a set without contours and for what regions_from_contours() refuses.
CoarseGround ground_of(const ContourSet& set, const RunContext& run);

/// Heights that a pass holds besides those of its outlines, ascending: for the first pass over a network `count`, or as
/// many as make contours lie five spacings apart if it is 0; later halfway between those before, where there is room.
std::vector<double> new_levels(const CoarseGround& ground, const Tin& tin, int count, const RunContext& run);

}  // namespace seamount::contour

// The tree of inclusion of contours (P2 sec. 3.1), which way they run, and whether they cross.
//
// P2 prints the nesting condition the wrong way round; meant is: of two contours around one place the higher one lies
// inside, h_i > h_j => Omega_i inside Omega_j, unless a basin lies between.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"

namespace seamount::geom {

/// Two contours that meet, or one (first == second) that meets itself.
struct ContourCrossing {
  size_t first, second;            ///< contours, first <= second
  size_t first_edge, second_edge;  ///< the edges of their rings; edge i leaves point i
  Vec2 at;
};

/// A place where any two rings cross or touch, or one crosses or touches itself; nothing if contours are as ContourSet
/// wants them. Always the same place for the same set. Points that repeat their neighbour are no touch. REQUIRES:
/// finite places. About n log n for n points; a million points take about half a second.
std::optional<ContourCrossing> find_contour_crossing(const std::vector<Contour>& contours, const RunContext& run = {});

/// For each contour the one that directly encloses it, or -1. REQUIRES: finite places, find_contour_crossing() finds
/// nothing, each ring at least three points. About n log n.
std::vector<int> find_contour_parents(const std::vector<Contour>& contours, const RunContext& run = {});

/// Sets `parent` and sorts parents before children: each contour is followed by all that it encloses, siblings keep
/// their order. Requires and costs the same.
void nest_contours(std::vector<Contour>& contours, const RunContext& run = {});

/// Turns rings so that higher ground is on their left, going by heights alone: a contour without parent is a hill, one
/// higher than its parent a hill, a lower one a basin. One at its parent's height is a basin in a hill and a hill in a
/// basin. REQUIRES: parents as nest_contours() sets them.
void orient_contours(std::vector<Contour>& contours);

/// Whether the contour encloses higher ground: its ring runs counter-clockwise.
bool is_hill(const Contour& contour);

}  // namespace seamount::geom

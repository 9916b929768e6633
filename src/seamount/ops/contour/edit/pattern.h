// Patterns: the contours within an outline, taken from one set and laid into another (P2 sec. 6.2 and 6.6).
//
// A pattern is a Drawing about its own middle: one area named "outline" and the lines within it and a little around it,
// so that the ground at the outline itself is known; higher ground on their left, heights above the outline's own (its
// mean, where contours cross it). It is small, and any GIS reads it.
//
// Pasting goes through the ground: both grounds are found between their contours on a lattice, the pattern's is fitted
// to the heights along the outline (a membrane over the differences: Perez, Gangnet and Blake, "Poisson image editing",
// 2003), both are blended over a ring, and contours of the result are joined to those outside (patch.h).
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/ops/contour/edit/tools.h"

namespace seamount::contour {

/// What an outline is made of: a polygon, or a contour of the set.
struct Outline {
  Polygon polygon;
  int contour = -1;  ///< the contour that it is, or -1
};

/// contour.pattern: nothing said: the whole frame is the outline.
struct PatternParams {
  std::vector<Polygon> within;
  Selection select;

  static constexpr auto fields() {
    using P = PatternParams;
    return std::tuple(field(&P::within, "within", "the outline: one polygon; the whole domain unless said"),
                      field(&P::select, "select", "in place of it: one contour, with all that lies inside it"));
  }
};

/// Throws InvalidArgument as find_outline() does, and where no contour comes into the outline.
Drawing pattern(const ContourSet& set, const PatternParams& params, const RunContext& run);

/// The one polygon or the one contour that a tool names. Throws InvalidArgument{name...} for neither, both, several.
Outline find_outline(const ContourSet& set, const std::vector<Polygon>& within, const Selection& select,
                     const std::string& name);

/// Linear in the set's points, times the outline's for those near it.
Drawing make_pattern(const ContourSet& set, const Outline& outline);

/// Throws InvalidArgument{name} where a pattern has no outline of one sound part, or no lines.
void check_pattern(const Drawing& pattern, const std::string& name);

/// Lays a pattern over the contours; says where that holds water back. About half a second for a lattice of 400 x 400.
void paste_pattern(const Drawing& pattern, const PasteTool& tool, ContourSet& set, const std::string& name,
                   const RunContext& run);

/// Removes what lies in the outline and closes the ground over it, as slopes around it go on; cuts valleys for water
/// that comes in, and says so.
void clear_outline(const Outline& outline, ContourSet& set, const std::string& name, const RunContext& run);

}  // namespace seamount::contour

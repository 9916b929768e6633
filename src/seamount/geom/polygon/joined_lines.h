// Lines that are pieces of longer ones, as coastline ways and tiled contours are, and the areas that lines enclose.
#pragma once

#include <cstddef>
#include <vector>

#include "seamount/model/areas.h"

namespace seamount::geom {

/// The lines with open ones joined where two ends of the same value (if `same_value`) lie within tolerance_m of each
/// other, each end with the nearest; a line that comes back to its start is closed. In the order of their first pieces,
/// whose attributes they keep; pieces are turned as needed. n log n.
std::vector<ValuedLine> join_lines(const std::vector<ValuedLine>& lines, bool same_value, double tolerance_m);

/// What lines enclose.
struct LineAreas {
  std::vector<NamedArea> areas;  ///< without names, one a ring, with the line's attributes
  std::vector<ValuedLine> open;  ///< lines that enclose nothing, joined
};

/// Closed lines and rings of open ones that meet end to end, whatever their values. n log n.
LineAreas areas_from_lines(const std::vector<ValuedLine>& lines);

}  // namespace seamount::geom

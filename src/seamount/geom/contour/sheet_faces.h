// Which side of each contour line in a sheet is the higher one (close_lines.h).
#pragma once

#include <cstddef>
#include <vector>

#include "seamount/model/areas.h"

namespace seamount::geom {

/// An open line in the order of the border: it goes from one end to another; ends are numbered counter-clockwise.
struct SheetLine {
  const ValuedLine* line = nullptr;
  size_t from = 0, to = 0;  ///< numbers of its first and its last end
  bool left_is_high = false;
};

struct SideGuess {
  size_t guessed = 0;  ///< lines whose sides only follow from how they run
};

/// Sets left_is_high of every line. `ends`: how many there are; stretch k of the border lies after end k.
/// `left_is_high`: for where nothing is known.
SideGuess find_sides(std::vector<SheetLine>& lines, size_t ends, const std::vector<ValuedLine>& rings,
                     bool left_is_high);

}  // namespace seamount::geom

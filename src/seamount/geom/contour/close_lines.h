// Open contour lines, as clipped map sheets and gdal_contour have them, closed along the border of their sheet.
//
// Which side of a line is higher follows from the heights around it. Lines cut the sheet into faces; a face that lies
// between lines of two heights is above the lower and below the higher ones, which says the same of the faces beyond
// lines that have one height on this side. Where only one height is known, lines run as most others do.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/contour/sheet.h"
#include "seamount/model/areas.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

struct CloseOptions {
  std::string field;          ///< what messages name
  double gap_m = 0.0;         ///< ends inside the sheet are joined over gaps up to this
  GridFrame frame;            ///< lines are closed beyond it too, where it leaves the sheet by some cells
  bool left_is_high = false;  ///< how lines run where nothing else says which side is higher
};

/// All lines as closed contours: open ones are closed beyond the border of the sheet, lower ones further out, and
/// heights that all of the border is above get a ring around the whole. Not nested yet; lines are turned at will. Says
/// how many gaps were closed and where sides are a guess. Throws InvalidArgument{field} with a place: an end inside the
/// sheet, a border along which heights contradict each other. n log n.
std::vector<Contour> close_lines(std::vector<ValuedLine> lines, const SheetBorder& sheet, const CloseOptions& options,
                                 const RunContext& run);

}  // namespace seamount::geom

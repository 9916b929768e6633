// Whether contours still nest as they did, looked at only where they changed.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/model/contour_set.h"

namespace seamount::contour {

/// A contour of which something moved.
struct MovedContour {
  size_t contour;                                ///< index in the set
  const Ring* ring;                              ///< what it is now
  std::vector<std::pair<size_t, size_t>> edges;  ///< runs [begin, end) of its edges that lie where anything moved
  bool wholly = false;                           ///< all of it does, so that it could have come to lie elsewhere
};

/// Two contours that meet, or one that has come to lie elsewhere than in its parent (then both are that one's edge 0).
struct NestingDefect {
  Vec2 at;
  size_t first, second;            ///< of the list of moved contours
  size_t first_edge, second_edge;  ///< edge i leaves point i of the ring
};

/// What is wrong when rings are replaced; a place may come more than once. Only where nothing meets are parents looked
/// at. `contours` and their parents are as before; `boxes` are theirs. n log n in the edges of the runs, and linear in
/// the contours for each that moved wholly.
std::vector<NestingDefect> find_nesting_defects(const std::vector<Contour>& contours,
                                                const std::vector<geom::Box>& boxes,
                                                const std::vector<MovedContour>& moved, const RunContext& run);

}  // namespace seamount::contour

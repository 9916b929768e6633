// Smoothing of contours (P2 sec. 5.1): every point moves towards the mean of its contour over an arc around it.
//
// Departures: the mean is over arc length, so that points close together count no more than points far apart; a closed
// loop keeps the area that averaging would take from it, by moving it out along its normals; contours stay where they
// leave the frame. Contours are smoothed one by one, so two of them can come to cross where little room is between
// them: there, and only there, smoothing is taken back by halves until they do not.
#pragma once

#include <optional>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"

namespace seamount::contour {

struct Smoothing {
  double radius_m = 0.0;  ///< half the arc that is averaged over; at most an eighth of a loop
  double strength = 1.0;  ///< alpha of P2: share of the way to the mean, in [0, 1]
  int rounds = 1;
};

/// Where smoothing had to be weakened.
struct Smoothed {
  size_t limited = 0;         ///< points smoothed by less than was asked for
  std::optional<Vec2> where;  ///< one of the places where contours would have met
};

/// Averages over the arc of 2 radius around each point of a ring, `rounds` times, and restores the area.
/// pinned[i]: the point stays, and arcs end there.
Ring smoothed_ring(const Ring& ring, const std::vector<char>& pinned, const Smoothing& smoothing);

/// Smooths the chosen contours. Same number of points. About n log n for the n points of the whole set; parallel over
/// contours.
Smoothed smooth_contours(ContourSet& set, const std::vector<size_t>& chosen, const Smoothing& smoothing,
                         const RunContext& run);

}  // namespace seamount::contour

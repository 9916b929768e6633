// What the tracers of contours share (marching_squares.h, marching_triangles.h and, for lines that end at a border,
// marching_open_triangles.h): crossings of contours and edges, numbered as they are found, and segments from crossing
// to crossing, joined into chains in linear time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {

/// Where a contour leaves one face and enters the next.
struct Crossing {
  Vec2 at;
  uint32_t level;  ///< which of the levels
};

/// A piece of a contour within one face, higher ground on its left, by numbers of crossings.
struct ContourSegment {
  uint32_t from, to;
};

struct ContourChain {
  Polyline points;
  uint32_t level = 0;
  bool closed = false;           ///< the last point is joined to the first
  uint32_t first = 0, last = 0;  ///< the crossings that it starts and ends at
};

/// A height below every level, for what lies beyond the edge where contours are closed there. REQUIRES: at least one
/// level.
inline double height_below(std::span<const double> levels) {
  const double fall = 0.25 * (levels.back() - levels.front());
  return levels.front() - (fall > 0.0 ? fall : 1.0);
}

/// How many of the ascending levels a value reaches: contours with level index < rank have it on their high side.
inline uint32_t level_rank(std::span<const double> levels, double value) {
  return static_cast<uint32_t>(std::upper_bound(levels.begin(), levels.end(), value) - levels.begin());
}

/// The share at which one of `count` levels crosses an edge, `position` of them nearer to the edge's start: within
/// (0, 1), never at an end and never where another level crosses, though the exact share may be. So contours do not
/// touch at samples that equal a level.
inline double spread_share(double exact, uint32_t position, uint32_t count) {
  const double step = 1e-4 / count;
  return std::clamp(exact, step * (position + 1), 1.0 - step * (count - position));
}

/// Joins segments into chains, in the order of their first segments, each starting where that one does; open chains
/// come first and start where nothing leads. REQUIRES: a crossing starts at most one segment and ends at most one.
std::vector<ContourChain> join_segments(std::span<const Crossing> crossings, std::span<const ContourSegment> segments,
                                        const RunContext& run);

}  // namespace seamount::geom

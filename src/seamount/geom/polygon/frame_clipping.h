// Rings clipped to a frame so that they still nest: each part outside is replaced by a narrow closing along the frame's
// edge.
//
// Tracers close contours a little beyond the frame or the network (contour.h, marching_triangles.h), drawn outlines go
// on as far as their authors like. Beyond the frame such rings may cross though they nest within it. Closed here
// together they nest: along the edge the stretches of land of nested rings are nested, and the longer stretch takes the
// closing further out.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// A clipped ring, or a part of one that the frame's edge cuts apart.
struct ClippedRing {
  size_t of;  ///< which of the rings
  Ring ring;  ///< runs the same way
};

/// The rings within the frame, in order; those that do not meet it go, those around all of it become rectangles.
/// Closings lie within `reach_m` of the frame. REQUIRES: finite places, simple rings; reach_m > 0. Rings that cross or
/// touch within the frame still do. n log n.
std::vector<ClippedRing> clip_to_frame(std::span<const Ring> rings, const GridFrame& frame, double reach_m);

/// What lies of a ring within a frame, running the same way.
struct FrameRun {
  Polyline points;
  bool closed = false;
};

/// The runs of a ring within the frame, from edge to edge; all of it, closed, where it leaves it nowhere. REQUIRES:
/// finite places. Linear.
std::vector<FrameRun> runs_in_frame(const Ring& ring, const GridFrame& frame);

}  // namespace seamount::geom

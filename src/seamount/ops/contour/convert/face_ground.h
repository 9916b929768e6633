// What the ways of contour.reconstruct share: the faces between contours, distances to their bounds, and how far the
// ground may leave the last contour where no further one bounds it. Not part of the public interface.
#pragma once

#include <cstdint>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/contour/faces.h"
#include "seamount/geom/contour/interpolation.h"
#include "seamount/model/contour_set.h"

namespace seamount::contour {

/// The faces between contours and what their ground may do.
struct FaceGround {
  geom::ContourFaces faces;
  geom::ContourInterpolation between;
  std::vector<float> reach_m;  ///< per face with one bound: how far its ground may rise or fall from it
  std::vector<float> slope;    ///< per face with one bound: metres a cell, that of the ground around it

  bool open(int32_t face) const { return faces.bounds_of(face) == 1; }
  float sign(int32_t face) const { return faces.rises(face) ? 1.0F : -1.0F; }
};

/// `summits`: the share of the usual interval by which summits may rise over the last contour.
FaceGround make_face_ground(const ContourSet& set, double summits, const GridFrame& frame, const RunContext& run);

/// The usual height between contours: the median step between the heights that occur; of a single height a twentieth of
/// the frame's shorter side.
double usual_interval(const ContourSet& set);

/// Rises from 0 with slope 1 and stays below 1: bending gently from the start, or late.
float saturated(float u);
float saturated_late(float u);

/// The lowest cell of each face in which water may stay.
std::vector<int64_t> basin_floors(const FaceGround& ground, const HeightField& heights);

/// Heights with slopes that go on across contours; drained. Takes what it does not need out of `ground` on its way, so
/// that no more than six copies of the terrain are held.
HeightField smooth_surface(const ContourSet& set, FaceGround ground, const RunContext& run);

}  // namespace seamount::contour

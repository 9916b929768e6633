// Heights between contours from the distances to them (P2 sec. 3.2, with the heights in their right places; Hormann,
// Spinello and Schroeder 2003): at distances d_k and d_{k+1} from the contours below and above
//
//   h = (d_{k+1} h_k + d_k h_{k+1}) / (d_k + d_{k+1}).
//
// Distances are exact and to the contours that bound the place's face, not to others that lie behind them; where more
// than two heights bound a face, each counts with the inverse of its distance, which is the same for two. Parts of
// contours outside the frame are left out: they only close what goes on there.
#pragma once

#include "seamount/geom/contour/faces.h"

namespace seamount::geom {

struct ContourInterpolation {
  Grid<int32_t> face;     ///< rasterise_faces()
  HeightField height_m;   ///< between the bounds of the face; the bound itself where there is one only
  ScalarField low, high;  ///< in cells, to the lowest and the highest bound of the face (the same where it has one);
                          ///< +infinity where none lies within the frame
};

/// REQUIRES: a nested and oriented set with at least one contour; `faces` are its own. Parallel; about cells x
/// log(edges near a cell), 16 bytes per cell.
ContourInterpolation interpolate_contours(const std::vector<Contour>& contours, const ContourFaces& faces,
                                          const GridFrame& frame, const RunContext& run);

}  // namespace seamount::geom

// Rays against a height field: the surface is bilinear between cell centres, the search skips whatever lies below the
// ray by a pyramid of maxima (Tevs, Ihrke and Seidel, "Maximum mipmaps for fast, accurate, and scalable dynamic height
// field rendering", I3D 2008).
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::render {

/// A ray in lattice units: columns, rows and metres of height at parameter t (metres along the ray).
struct LatticeRay {
  float column, row, height;     ///< at t = 0
  float dcolumn, drow, dheight;  ///< per metre
};

class Tracer {
 public:
  /// Keeps a reference to the heights. REQUIRES: at least 2 x 2 finite cells. A third more memory than they take.
  Tracer(const HeightField& heights, const RunContext& run);

  /// First t in [begin, end] where the ray meets or is below the surface, or a negative number. REQUIRES: the ray is
  /// over the lattice [0, width - 1] x [0, height - 1] on the whole interval.
  float trace(const LatticeRay& ray, float begin, float end) const;

  /// The part [begin, end] of the ray that is over the lattice; false if there is none.
  bool clip(const LatticeRay& ray, float& begin, float& end) const;

  float height(float column, float row) const;
  float highest() const { return maxima_.back()(0, 0); }

 private:
  float meet_patch(const LatticeRay& ray, int x, int y, float begin, float end) const;

  const HeightField& heights_;
  std::vector<Grid<float>> maxima_;  ///< [0]: over each patch of four centres; then 2 x 2 of the level below
};

}  // namespace seamount::render

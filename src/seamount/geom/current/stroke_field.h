// The displacement (P0 eq. 1.3 to 1.5) or the current (P3 sec. 1.7.1) that strokes ask for.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/vector_field.h"

namespace seamount::geom {

/// Phi(p) = sum over strokes of strength C'(p*) / |C'(p*)| exp(-|p - p*|^2 / (2 width^2)), in the strokes' unit, metres
/// or m/s. Strokes of about one width share a lattice with at least eight nodes per width. Where several parts of a
/// stroke are about equally near, its direction is their mean, weighted over a third of the width: the direction of the
/// nearest alone (eq. 1.3) jumps there, and a warp that jumps tears the terrain. Strokes reach 4 widths; what of them
/// lies further than 16 domains away is cut off. Parallel; about 2 ns per lattice node and stroke.
class StrokeField {
 public:
  StrokeField(const std::vector<Stroke>& strokes, const GridFrame& frame, const RunContext& run);

  bool empty() const { return layers_.empty(); }

  /// Displacement at a place, from all layers.
  Vec2 at(double x, double y) const;

  /// Reads rows of cells; one per thread.
  class Rows {
   public:
    explicit Rows(const StrokeField& field);
    /// East and north displacement at (x0 + i dx, y).
    void read(double x0, double dx, double y, std::span<float> east, std::span<float> north);

   private:
    std::vector<RowUpsampler> east_, north_;
    std::vector<float> line_;
  };

 private:
  struct Layer {
    ScalarField east, north;
  };
  std::vector<Layer> layers_;
};

/// Adds strokes to a current; their strengths are speeds here, m/s. InvalidArgument "strokes[3]" for one with fewer
/// than two points or numbers that are none.
void add_strokes(const std::vector<Stroke>& strokes, VectorField& current, const RunContext& run);

}  // namespace seamount::geom

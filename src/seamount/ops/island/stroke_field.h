// The displacement that strokes of wind ask for (P0 eq. 1.3 to 1.5), and the radial strokes of fig. 1.38.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/grid/lattice_rows.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::island {

/// Phi(p) = sum over strokes of strength C'(p*) / |C'(p*)| exp(-|p - p*|^2 / (2 width^2)), metres. Strokes of about one
/// width share a lattice with at least eight nodes per width. Where several parts of a stroke are about equally near,
/// its direction is their mean, weighted over a third of the width: the direction of the nearest alone (eq. 1.3) jumps
/// there, and a warp that jumps tears the terrain. Strokes reach 4 widths; what of them lies further than 16 domains
/// away is cut off. Parallel; about 2 ns per lattice node and
/// stroke.
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
    std::vector<geom::LatticeRows> east_, north_;
    std::vector<float> line_;
  };

 private:
  struct Layer {
    ScalarField east, north;
  };
  std::vector<Layer> layers_;
};

/// Radial strokes from the centre to `reach_m`, at about equal angles, landward and seaward in turn; width and strength
/// vary by a third.
std::vector<Stroke> radial_strokes(int count, double width_m, double strength_m, Vec2 centre, double reach_m,
                                   Seed seed);

}  // namespace seamount::island

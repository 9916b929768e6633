// The region coordinate x~: where a place lies across the regions of an island (P0 eq. 1.1 and its general form).
//
// Between outlines i and i + 1, x~ = i + d_i / (d_i + d_{i+1}). In polar form d are differences of radii along the ray,
// which is eq. 1.1 as printed. For areas of any form d are distances to the outlines, smoothed the more the further
// they are, since distances alone have creases along the medial axis; inside the innermost outline the summits stand
// for outline 0 (summits.h). x~ is continuous, 0 at the highest summit and clamped to 5 beyond the last outline.
#pragma once

#include <span>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/island/shape.h"
#include "seamount/ops/island/summits.h"

namespace seamount::island {

/// The summits of the land and how it falls from them.
struct Interior {
  std::vector<Peak> peaks;  ///< highest first; empty: one of equal height for every lobe
  geom::CurveFunction shape{{{{0.0, 1.0}, {1.0, 0.0}}}, geom::CurveKind::linear};  ///< share of the height over x~
  double foot_m = 0;                                                               ///< height of the mountains' foot
  double width_variation = 0;  ///< how uneven derived widths are along the coast, in [0, 1]
  double unevenness = 0;       ///< how far slopes are bent out of the round, in [0, 1]
  Seed seed = {};
};

/// x~ of a plan, ready to be read along rows of any frame.
class RegionCoordinate {
 public:
  /// `smoothing` in [0, 1]: how much creases of distance fields are softened; 0 gives plain distances. For areas,
  /// fields are computed on a lattice of at most 1024 nodes a side, whatever the frame's size, so that a preview shows
  /// the same island. About 80 ns of CPU time per node.
  RegionCoordinate(const Plan& plan, const GridFrame& frame, double smoothing, const RunContext& run,
                   const Interior& interior = {});

  /// out[i] = x~ at (x0 + i dx, y). `shift_m` (empty: none) is added to the distance from the coast: its irregular
  /// detail.
  void row(double x0, double dx, double y, std::span<const float> shift_m, std::span<float> out) const;

 private:
  void prepare_polar(const Plan& plan, const Interior& interior);
  void prepare_areas(const Plan& plan, double smoothing, const Interior& interior, const RunContext& run);
  void polar_row(double x0, double dx, double y, std::span<const float> shift_m, std::span<float> out) const;
  void area_row(double x0, double dx, double y, std::span<const float> shift_m, std::span<float> out) const;

  /// An outline as a level of a distance field: signed distance = fields_[field] - offset_m.
  struct Level {
    int field = 0;
    double offset_m = 0;
  };

  /// x~ inside the innermost outline, as v = 1 - x~.
  struct Dome {
    ScalarField v;      ///< 0 on the outline, 1 at the summit
    ScalarField slope;  ///< v per metre of depth inside the outline, near it
  };

  GridFrame lattice_;
  // Polar form: radii of the outlines per angle, one table after another.
  Vec2 centre_;
  std::vector<float> radii_;
  // General form.
  std::vector<ScalarField> fields_;
  std::vector<Level> levels_;  ///< outlines first_ .. 4
  ScalarField widths_;         ///< factor of the levels' offsets; empty: 1
  Dome dome_;
  int first_ = 0;  ///< index of the innermost outline that encloses anything
};

/// x~ of a label map alone, for terrain that was not made here: per region the distances to what lies inside and
/// outside of it. Inside the innermost region it is 1 - depth / greatest depth. Linear time, parallel.
ScalarField coordinate_from_labels(const LabelMap& labels, const RunContext& run);

}  // namespace seamount::island

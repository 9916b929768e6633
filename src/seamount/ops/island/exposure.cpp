#include "seamount/ops/island/exposure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/upsample_rows.h"

namespace seamount::island {

ScalarField exposure(const ScalarField& coordinate, double swell_from_deg, double smooth_m, const RunContext& run) {
  constexpr int kSide = 256;
  const GridFrame lattice = geom::coarser_frame(
      coordinate.frame(), std::max(coordinate.frame().width_m(), coordinate.frame().height_m()) / kSide);
  ScalarField x = geom::resample(coordinate, lattice, run);
  geom::gaussian_blur(x, smooth_m, run);
  const double bearing = swell_from_deg * std::numbers::pi / 180.0;
  ScalarField out(lattice, 0.0F);
  for (int row = 0; row < lattice.height; ++row) {
    for (int column = 0; column < lattice.width; ++column) {
      const double east = x.clamped(column + 1, row) - x.clamped(column - 1, row);
      const double north = x.clamped(column, row - 1) - x.clamped(column, row + 1);
      const double steep = std::hypot(east, north);
      if (steep < 1e-6) continue;
      out(column, row) = static_cast<float>((east * std::sin(bearing) + north * std::cos(bearing)) / steep);
    }
  }
  geom::gaussian_blur(out, 0.5 * smooth_m, run);
  return out;
}

}  // namespace seamount::island

#include "seamount/ops/island/coast_room.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/polygon/distance.h"

namespace seamount::island {

ScalarField coast_room(const Plan& plan, const GridFrame& frame, const RunContext& run) {
  constexpr int kSide = 512;
  constexpr double kRidge = 0.6;  // the distance's gradient is below this in the middle of the land, else 1
  const GridFrame lattice = geom::coarser_frame(frame, std::max(frame.width_m(), frame.height_m()) / kSide);
  const ScalarField distance = geom::signed_distance(land_of(plan), lattice, run);
  Grid<uint8_t> middle(lattice);
  for (int y = 0; y < lattice.height; ++y) {
    for (int x = 0; x < lattice.width; ++x) {
      const double east = distance.clamped(x + 1, y) - distance.clamped(x - 1, y);
      const double north = distance.clamped(x, y - 1) - distance.clamped(x, y + 1);
      const bool ridge = std::hypot(east, north) < 2.0 * lattice.cell_m * kRidge;
      middle(x, y) = distance(x, y) < 0.0F && ridge ? 1 : 0;
    }
  }
  Grid<int32_t> nearest(lattice);
  geom::nearest_feature(middle, nearest, run);
  ScalarField room(lattice);
  for (size_t c = 0; c < room.size(); ++c) {
    const int32_t at = nearest.cells()[c];
    room.cells()[c] = at < 0 ? 0.0F : -0.5F * distance.cells()[static_cast<size_t>(at)];
  }
  geom::gaussian_blur(room, 1.5 * lattice.cell_m, run);
  return room;
}

}  // namespace seamount::island

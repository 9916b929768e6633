#include "seamount/ops/island/river_mouths.h"

#include <algorithm>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/upsample_rows.h"
#include "seamount/geom/water/flow.h"

namespace seamount::island {

std::vector<RiverMouth> river_mouths(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  constexpr int kSide = 256;
  constexpr double kLeast = 0.01;
  const GridFrame lattice =
      geom::coarser_frame(terrain.frame(), std::max(terrain.frame().width_m(), terrain.frame().height_m()) / kSide);
  const HeightField coarse = geom::resample(terrain, lattice, run);
  const HeightField filled = geom::fill_depressions(coarse, sea_level_m, run);
  const geom::FlowDirections directions = geom::flow_directions(filled, sea_level_m, run);
  const Grid<uint32_t> gathered = geom::flow_accumulation(directions, run);
  const auto land =
      std::count_if(filled.cells().begin(), filled.cells().end(), [&](float z) { return z > sea_level_m; });
  std::vector<RiverMouth> mouths;
  for (int y = 0; y < lattice.height; ++y) {
    for (int x = 0; x < lattice.width; ++x) {
      const uint8_t way = directions(x, y);
      if (way >= 8 || !(filled(x, y) > sea_level_m) || gathered(x, y) < kLeast * static_cast<double>(land)) continue;
      const int to_x = x + geom::kFlowDx[way], to_y = y + geom::kFlowDy[way];
      if (filled(to_x, to_y) > sea_level_m) continue;
      mouths.push_back({{lattice.x(x), lattice.y(y)}, gathered(x, y) * lattice.cell_m * lattice.cell_m});
    }
  }
  std::stable_sort(mouths.begin(), mouths.end(),
                   [](const RiverMouth& a, const RiverMouth& b) { return a.catchment_m2 > b.catchment_m2; });
  return mouths;
}

}  // namespace seamount::island

#include "seamount/geom/water/flow_invert.h"

#include "seamount/base/parallel.h"

namespace seamount::geom {

HeightField invert_with_walls(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  GridFrame wider = terrain.frame();
  wider.width += 2;
  wider.height += 2;
  wider.west_m -= wider.cell_m;
  wider.north_m += wider.cell_m;
  HeightField inverted(wider, kFlowWall);
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        if (terrain(x, y) > sea_level_m) inverted(x + 1, y + 1) = -terrain(x, y);
      }
    }
  });
  return inverted;
}

}  // namespace seamount::geom

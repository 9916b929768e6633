#include "seamount/ops/hydrology/ridge_flow.h"

#include "seamount/base/parallel.h"
#include "seamount/geom/water/flow_invert.h"

namespace seamount::hydrology {

RidgeFlow ridge_flow(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  const GridFrame& frame = terrain.frame();
  HeightField inverted = geom::invert_with_walls(terrain, sea_level_m, run.part(0.0, 0.1));
  geom::FlowDirections directions = geom::flow_directions(inverted, geom::kNoSea, run.part(0.1, 0.3));
  geom::route_through_pits(inverted, directions, geom::kFlowWall, run.part(0.3, 0.8));
  inverted = {};
  RidgeFlow out{geom::FlowDirections(frame), ScalarField(frame), Grid<uint8_t>(frame)};
  ScalarField weights(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const bool land = terrain(x, y) > sea_level_m;
        out.land(x, y) = land ? 1 : 0;
        weights(x, y) = land ? 1.0F : 0.0F;
        out.directions(x, y) = land ? directions(x + 1, y + 1) : geom::kOutlet;
      }
    }
  });
  out.cells = geom::flow_accumulation(out.directions, weights, run.part(0.8, 1.0));
  return out;
}

}  // namespace seamount::hydrology

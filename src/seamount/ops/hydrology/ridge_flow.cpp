#include "seamount/ops/hydrology/ridge_flow.h"

#include "seamount/base/parallel.h"

namespace seamount::hydrology {

RidgeFlow ridge_flow(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  // A wall around the map and over the sea: nothing leaves, and no way leads across.
  constexpr float kWall = 1e9F;
  const GridFrame& frame = terrain.frame();
  GridFrame wider = frame;
  wider.width += 2;
  wider.height += 2;
  HeightField inverted(wider, kWall);
  RidgeFlow out{geom::FlowDirections(frame), ScalarField(frame), Grid<uint8_t>(frame)};
  ScalarField weights(frame);
  parallel_rows(run.part(0.0, 0.1), frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const bool land = terrain(x, y) > sea_level_m;
        if (land) inverted(x + 1, y + 1) = -terrain(x, y);
        out.land(x, y) = land ? 1 : 0;
        weights(x, y) = land ? 1.0F : 0.0F;
      }
    }
  });
  geom::FlowDirections directions = geom::flow_directions(inverted, geom::kNoSea, run.part(0.1, 0.3));
  geom::route_through_pits(inverted, directions, kWall, run.part(0.3, 0.8));
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const uint8_t code = directions(x + 1, y + 1);
        // The wall's own level ground drains along itself or into the frame, of no interest.
        out.directions(x, y) = out.land(x, y) != 0 ? code : geom::kOutlet;
      }
    }
  });
  out.cells = geom::flow_accumulation(out.directions, weights, run.part(0.8, 1.0));
  return out;
}

}  // namespace seamount::hydrology

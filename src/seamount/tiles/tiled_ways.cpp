#include "seamount/tiles/tiled_ways.h"

#include <string_view>

#include "seamount/tiles/reduced_pictures.h"
#include "seamount/tiles/tiled_resample.h"
#include "seamount/tiles/tiled_water.h"

namespace seamount::tiles {
namespace {

constexpr TiledWay kWays[] = {{.op = "hydrology.fill", .refusal = fill_refusal, .run = run_tiled_fill, .spread = true},
                              {.op = "hydrology.flow", .refusal = flow_refusal, .run = run_tiled_flow, .spread = true},
                              {"terrain.resample", resample_refusal, run_tiled_resample},
                              {"render.map", picture_refusal, run_reduced_picture},
                              {"render.perspective", picture_refusal, run_reduced_picture},
                              {"render.relief", picture_refusal, run_reduced_picture},
                              {"render.texture", picture_refusal, run_reduced_picture}};

}  // namespace

const TiledWay* find_tiled_way(const recipe::Step& step) {
  for (const TiledWay& way : kWays) {
    if (step.op->name == std::string_view(way.op)) return &way;
  }
  return nullptr;
}

}  // namespace seamount::tiles

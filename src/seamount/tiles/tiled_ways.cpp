#include "seamount/tiles/tiled_ways.h"

#include <string_view>

#include "seamount/tiles/tiled_crop.h"
#include "seamount/tiles/tiled_import.h"
#include "seamount/tiles/tiled_mask.h"
#include "seamount/tiles/tiled_resample.h"
#include "seamount/tiles/tiled_water.h"

namespace seamount::tiles {
namespace {

constexpr TiledWay kWays[] = {
    {"hydrology.fill", fill_refusal, run_tiled_fill}, {"hydrology.flow", flow_refusal, run_tiled_flow},
    {"terrain.crop", crop_refusal, run_tiled_crop},   {"terrain.import", import_refusal, run_tiled_import, import_size},
    {"terrain.mask", mask_refusal, run_tiled_mask},   {"terrain.resample", resample_refusal, run_tiled_resample}};

}  // namespace

const TiledWay* find_tiled_way(const recipe::Step& step) {
  for (const TiledWay& way : kWays) {
    if (step.op->name == std::string_view(way.op)) return &way;
  }
  return nullptr;
}

}  // namespace seamount::tiles

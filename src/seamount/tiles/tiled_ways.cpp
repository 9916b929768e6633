#include "seamount/tiles/tiled_ways.h"

#include <string_view>

#include "seamount/tiles/reduced_pictures.h"
#include "seamount/tiles/tiled_crop.h"
#include "seamount/tiles/tiled_import.h"
#include "seamount/tiles/tiled_mask.h"
#include "seamount/tiles/tiled_resample.h"
#include "seamount/tiles/tiled_water.h"

namespace seamount::tiles {
namespace {

constexpr TiledWay kWays[] = {
    {.op = "hydrology.fill", .refusal = fill_refusal, .run = run_tiled_fill, .spread = true},
    {.op = "hydrology.flow", .refusal = flow_refusal, .run = run_tiled_flow, .spread = true},
    {.op = "terrain.crop", .refusal = crop_refusal, .run = run_tiled_crop},
    {.op = "terrain.import", .refusal = import_refusal, .run = run_tiled_import, .size = import_size},
    {.op = "terrain.mask", .refusal = mask_refusal, .run = run_tiled_mask, .spread = true},
    {.op = "terrain.resample", .refusal = resample_refusal, .run = run_tiled_resample},
    {.op = "render.map", .refusal = picture_refusal, .run = run_reduced_picture},
    {.op = "render.perspective", .refusal = picture_refusal, .run = run_reduced_picture},
    {.op = "render.relief", .refusal = picture_refusal, .run = run_reduced_picture},
    {.op = "render.texture", .refusal = picture_refusal, .run = run_reduced_picture}};

}  // namespace

const TiledWay* find_tiled_way(const recipe::Step& step) {
  for (const TiledWay& way : kWays) {
    if (step.op->name == std::string_view(way.op)) return &way;
  }
  return nullptr;
}

}  // namespace seamount::tiles

#include "seamount/recipe/draw_again.h"

#include "seamount/ops/sketch/extract.h"

namespace seamount::recipe {

Drawing draw_again(const HeightField& terrain, double least_m2, Seed seed, const RunContext& run) {
  const sketch::ExtractParams params{
      .coarse_m = 1.5 * terrain.cell_m(), .min_area_m2 = least_m2, .cue_area_m2 = 1.7 * least_m2, .sea = false};
  return sketch::extract(terrain, params, seed, run).lines;
}

}  // namespace seamount::recipe

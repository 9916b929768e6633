#include "seamount/ops/terrain/smooth.h"

#include <algorithm>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/model/same_size.h"

namespace seamount::terrain {

Reach smooth_reach(const SmoothParams& params, double cell_m) {
  return Reach::neighbourhood(geom::blur_reach(params.radius_m, cell_m));
}

HeightField smooth(const HeightField& terrain, const ScalarField* mask, const SmoothParams& params,
                   const RunContext& run) {
  check_params(params);
  if (mask != nullptr) check_same_size("mask", mask->frame(), terrain.frame());
  HeightField mean = terrain;
  geom::gaussian_blur(mean, params.radius_m, run.part(0.0, 0.8));
  const auto strength = static_cast<float>(params.strength);
  parallel_rows(run.part(0.8, 1.0), terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        const float here = mask == nullptr ? strength : strength * std::clamp((*mask)(x, y), 0.0F, 1.0F);
        mean(x, y) = terrain(x, y) + here * (mean(x, y) - terrain(x, y));
      }
    }
  });
  return mean;
}

}  // namespace seamount::terrain

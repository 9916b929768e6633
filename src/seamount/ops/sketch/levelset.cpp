#include "seamount/ops/sketch/levelset.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/quantile.h"

namespace seamount::sketch {
namespace {

float percentile_of(const ScalarField& field, double percentile) {
  return geom::quantile(std::vector<float>(field.cells().begin(), field.cells().end()), percentile / 100.0);
}

}  // namespace

Levelset levelset(const HeightField& terrain, const LevelsetParams& params, const RunContext& run) {
  check_params(params);
  const GridFrame& frame = terrain.frame();
  constexpr double kBlurPart = 64.0;
  constexpr float kRounding = 1e-6F;
  HeightField blurred = terrain;
  geom::gaussian_blur(blurred, params.blur_m.value_or(std::max(frame.width_m(), frame.height_m()) / kBlurPart), run);
  run.check_cancelled();
  const float level = percentile_of(blurred, params.percentile);
  // Above it: a sea that is level, up to what a blur rounds, is not.
  const auto [low, high] = std::minmax_element(blurred.cells().begin(), blurred.cells().end());
  const float least = std::nextafter(level + kRounding * (*high - *low), INFINITY);
  Levelset out{Mask(frame), Image(frame.width, frame.height), {}, level};
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < frame.width; ++x) {
      const bool inside = blurred(x, y) >= least;
      out.mask(x, y) = inside ? 1.0F : 0.0F;
      if (inside) std::fill_n(out.image.pixel(x, y), 3, uint8_t{255});
    }
  }
  out.areas.crs = frame.crs;
  if (*high >= least)
    out.areas.areas.push_back({"levelset", geom::trace_areas(blurred, least, run), {{"level_m", level}}});
  return out;
}

}  // namespace seamount::sketch

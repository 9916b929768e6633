#include "seamount/ops/sketch/levelset.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/scalar/quantile.h"
#include "seamount/ops/sketch/ground.h"

namespace seamount::sketch {

Levelset levelset(const HeightField& terrain, const LevelsetParams& params, const RunContext& run) {
  check_params(params);
  const GridFrame& frame = terrain.frame();
  constexpr double kBlurPart = 64.0;
  constexpr float kRounding = 1e-6F;
  const Ground ground = find_ground(terrain, params.sea, params.min_sea_m2, run);
  const double blur_m = params.blur_m.value_or(std::max(frame.width_m(), frame.height_m()) / kBlurPart);
  const HeightField blurred = blurred_land(ground, blur_m, frame, run);
  run.check_cancelled();
  Levelset out{Mask(frame, 0.0F), Image(frame.width, frame.height), {}, 0.0};
  out.areas.crs = frame.crs;
  std::vector<float> heights;
  for (size_t i = 0; i < blurred.size(); ++i)
    if (ground.is_land(i)) heights.push_back(blurred.data()[i]);
  if (heights.empty()) return out;
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const float low = *lowest, high = *highest, level = geom::quantile(std::move(heights), params.percentile / 100.0);
  out.level_m = static_cast<double>(level);
  // Above it: a plain that is level, up to what a blur rounds, is not.
  const float least = std::nextafter(level + kRounding * (high - low), INFINITY);
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < frame.width; ++x) {
      if (blurred(x, y) < least) continue;
      out.mask(x, y) = 1.0F;
      std::fill_n(out.image.pixel(x, y), 3, uint8_t{255});
    }
  }
  if (high >= least)
    out.areas.areas.push_back({"levelset", geom::trace_areas(blurred, least, run), {{"level_m", out.level_m}}});
  return out;
}

}  // namespace seamount::sketch

#include "seamount/ops/render/ground_cover.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/render/colour.h"
#include "seamount/ops/render/light.h"

namespace seamount::render {
namespace {

constexpr int kMostCells = 1024;

/// Gradient of a field at a cell, per metre, x east and y north.
struct Gradient {
  float x, y;
};

Gradient gradient(const Grid<float>& h, int x, int y) {
  const auto half = static_cast<float>(0.5 / h.cell_m());
  return {half * (h.clamped(x + 1, y) - h.clamped(x - 1, y)), half * (h.clamped(x, y - 1) - h.clamped(x, y + 1))};
}

/// 1 where the sea is.
Grid<uint8_t> sea_of(const HeightField& level, const Mask& dry) {
  Grid<uint8_t> sea(level.frame());
  for (size_t i = 0; i < level.size(); ++i)
    sea.data()[i] = level.data()[i] <= 0.0F && (dry.empty() || dry.data()[i] < 0.5F) ? 1 : 0;
  return sea;
}

ScalarField wetness(const HeightField& level, const Grid<uint8_t>& sea, const RunContext& run) {
  HeightField ground = level;
  bool any_sea = false;
  for (size_t i = 0; i < ground.size(); ++i) {
    any_sea = any_sea || sea.data()[i] != 0;
    if (sea.data()[i] == 0) ground.data()[i] = std::max(ground.data()[i], 0.01F);  // dry hollows drain too
  }
  const float sea_level = any_sea ? 0.0F : geom::kNoSea;
  const HeightField filled = geom::fill_depressions(ground, sea_level, run);
  const Grid<uint32_t> cells = geom::flow_accumulation(geom::flow_directions(filled, sea_level, run), run);
  ScalarField wet(level.frame());
  const auto cell = static_cast<float>(level.cell_m());
  parallel_rows(run, wet.width(), wet.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < wet.width(); ++x) {
        const Gradient g = gradient(filled, x, y);
        const float area = static_cast<float>(cells(x, y)) * cell;  // per metre of contour
        constexpr float kLeast = 0.03F;                             // a plain is not endlessly wet
        const float index = std::log(area / (std::sqrt(g.x * g.x + g.y * g.y) + kLeast));
        wet(x, y) = sea(x, y) != 0 ? 1.0F : ramp(6.5F, 12.5F, index);
      }
    }
  });
  geom::gaussian_blur(wet, 0.8 * wet.cell_m(), run);
  return wet;
}

ScalarField rain_share(const HeightField& level, const Grid<uint8_t>& sea, double wind_from, const RunContext& run) {
  HeightField air = level;  // the ground as moving air takes it
  for (float& h : air.cells()) h = std::max(h, 0.0F);
  const double size = std::max(air.frame().width_m(), air.frame().height_m());
  geom::gaussian_blur(air, std::clamp(0.02 * size, 2.0 * air.cell_m(), std::max(2500.0, 2.0 * air.cell_m())), run);
  constexpr double kFall = 0.07, kSoft = 0.03;  // radians
  const Grid<float> open = sun_visibility(air, {wind_from, kFall}, kSoft, run);
  const auto to_x = static_cast<float>(std::sin(wind_from)), to_y = static_cast<float>(std::cos(wind_from));
  ScalarField rain(level.frame());
  double sum = 0.0;
  int64_t count = 0;
  for (int y = 0; y < rain.height(); ++y) {
    if (y % 64 == 0) run.check_cancelled();
    for (int x = 0; x < rain.width(); ++x) {
      const Gradient g = gradient(air, x, y);
      const float rise = std::clamp(-(g.x * to_x + g.y * to_y), 0.0F, 0.4F);
      rain(x, y) =
          (1.0F + 4.0F * rise) * (1.0F + std::min(air(x, y), 3000.0F) / 3000.0F) * mix(0.38F, 1.0F, open(x, y));
      if (sea(x, y) != 0) continue;
      sum += rain(x, y);
      ++count;
    }
  }
  const float scale = count > 0 ? static_cast<float>(static_cast<double>(count) / sum) : 1.0F;
  for (float& r : rain.cells()) r *= scale;
  geom::gaussian_blur(rain, 3.0 * rain.cell_m(), run);
  return rain;
}

}  // namespace

Grid<CoverTexel> ground_cover(const HeightField& heights, const Mask& dry, const LabelMap* labels, double exaggeration,
                              double wind_from, const RunContext& run) {
  HeightField level = reduce(heights, kMostCells, run);
  const Openness open = openness(level, run);
  const auto flatten = static_cast<float>(1.0 / exaggeration);
  for (float& h : level.cells()) h *= flatten;
  const Grid<uint8_t> sea = sea_of(level, dry.empty() ? dry : reduce(dry, kMostCells, run));
  const ScalarField wet = wetness(level, sea, run), rain = rain_share(level, sea, wind_from, run);
  Grid<uint8_t> land(sea.frame());
  for (size_t i = 0; i < sea.size(); ++i) land.data()[i] = sea.data()[i] == 0 ? 1 : 0;
  const ScalarField to_sea = geom::distance_to(sea, run), to_land = geom::distance_to(land, run);
  Grid<CoverTexel> texels(level.frame());
  parallel_rows(run, level.width(), level.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < level.width(); ++x) {
        CoverTexel& texel = texels(x, y);
        texel.sky = open.sky(x, y);
        texel.concavity = flatten * open.concavity(x, y);
        texel.wet = wet(x, y);
        texel.rain = rain(x, y);
        texel.shore_m = std::min(to_sea(x, y) + to_land(x, y), kFarthestShore);  // one of them is 0
        if (labels == nullptr) continue;
        const auto column = static_cast<int>((x + 0.5) * labels->width() / level.width());
        const auto row = static_cast<int>((y + 0.5) * labels->height() / level.height());
        const Region region = labels->clamped(column, row);
        texel.beach = region == Region::beach ? 1.0F : 0.0F;
        texel.lagoon = region == Region::lagoon ? 1.0F : 0.0F;
        texel.reef = region == Region::reef ? 1.0F : 0.0F;
      }
    }
  });
  return texels;
}

}  // namespace seamount::render

#include "seamount/ops/render/relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/ops/render/ground.h"
#include "seamount/ops/render/shading.h"
#include "seamount/ops/render/standing_water.h"
#include "seamount/ops/render/tints.h"
#include "seamount/ops/render/unknown.h"

namespace seamount::render {

HeightField picture_terrain(const HeightField& terrain, int width_px, const RunContext& run) {
  const GridFrame& from = terrain.frame();
  GridFrame frame = from;
  frame.width = width_px;
  frame.cell_m = from.width_m() / width_px;
  frame.height = static_cast<int>(std::clamp(std::round(from.height_m() / frame.cell_m), 1.0, 16384.0));
  return geom::resample(terrain, frame, run);
}

Grid<uint8_t> picture_dry(const HeightField& terrain, const HeightField& picture,
                          const std::optional<double>& min_sea_m2, const RunContext& run) {
  const Mask dry = dry_below_sea(terrain, min_sea_m2, run);
  if (dry.empty()) return {};
  const Mask shown = geom::resample(dry, picture.frame(), run);
  Grid<uint8_t> below(picture.frame());
  for (size_t i = 0; i < below.size(); ++i)
    below.data()[i] = shown.data()[i] >= 0.5F && picture.data()[i] < 0.0F ? 1 : 0;
  return below;
}

LowestGround lowest_ground(const HeightField& picture, const Grid<uint8_t>& dry) {
  LowestGround lowest{0.0, std::numeric_limits<double>::infinity()};
  for (size_t i = 0; i < picture.size(); ++i) {
    const double z = picture.data()[i];
    if (z < 0.0 && (dry.empty() || dry.data()[i] == 0))
      lowest.sea_m = std::min(lowest.sea_m, z);
    else
      lowest.land_m = std::min(lowest.land_m, z);
  }
  if (lowest.sea_m < 0.0) lowest.land_m = std::min(lowest.land_m, 0.0);
  return lowest;
}

Rgb shaded(Rgb tint, float shade) {
  constexpr Rgb kShadow{0.10F, 0.115F, 0.18F}, kLight{1.0F, 0.985F, 0.93F};
  if (shade < 1.0F) {
    // From the tint at 1 to a blue-grey version of it at 0.
    return mix(tint * kShadow, tint, std::pow(std::max(0.0F, shade), 1.4F));
  }
  // Brighter by at most a half, and a little of that as warm light of its own where the tint is bright.
  const float more = (shade - 1.0F) / (1.0F + 0.9F * (shade - 1.0F));
  const Rgb bright = (1.0F + 0.9F * more) * tint;
  return mix(bright, kLight, clamp01(0.9F * more * luminance(tint)));
}

Image relief(const HeightField& terrain, const ReliefParams& params, const RunContext& run) {
  check_params(params);
  check_visible(terrain, nullptr, run);
  HeightField ground = picture_terrain(terrain, params.width_px, run.part(0.0, 0.2));
  Filled filled = fill_unknown(ground, run);
  if (!filled.terrain.empty()) ground = std::move(filled.terrain);
  constexpr double kDegree = std::numbers::pi / 180.0;
  const Grid<float> shade = relief_shading(ground,
                                           {.light_azimuth = params.light_azimuth_deg * kDegree,
                                            .light_elevation = params.light_elevation_deg * kDegree,
                                            .exaggeration = params.vertical_exaggeration,
                                            .ambient = params.ambient},
                                           run.part(0.2, 0.9));
  const Grid<uint8_t> dry =
      params.tint == ReliefTint::grey ? Grid<uint8_t>() : picture_dry(terrain, ground, params.min_sea_m2, run);
  const LowestGround lowest = lowest_ground(ground, dry);
  const TintScale scale(lowest.sea_m, lowest.land_m, *std::max_element(ground.cells().begin(), ground.cells().end()));
  constexpr Rgb kPaper{0.585F, 0.585F, 0.58F};
  Image image(ground.width(), ground.height());
  parallel_rows(run.part(0.9, 1.0), image.width, image.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const bool unknown = !filled.unknown.empty() && filled.unknown(x, y) != 0;
        const bool land = !dry.empty() && dry(x, y) != 0;
        const Rgb tint = params.tint == ReliefTint::grey ? kPaper : scale.tint(ground(x, y), land);
        write_dithered(image.pixel(x, y), x, y, unknown ? kUnknownGround : shaded(tint, shade(x, y)));
      }
    }
  });
  return image;
}

}  // namespace seamount::render

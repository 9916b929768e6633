// render.relief: shaded relief, grey or tinted by height, without any furniture.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/ops/render/colour.h"

namespace seamount::render {

/// What the relief is coloured by.
enum class ReliefTint { grey, height };

struct ReliefParams {
  int width_px = 1600;
  ReliefTint tint = ReliefTint::grey;
  double light_azimuth_deg = 315.0;
  double light_elevation_deg = 45.0;
  double ambient = 0.6;
  std::optional<double> vertical_exaggeration;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = ReliefParams;
    return std::tuple(
        field(&P::width_px, "width_px", "", between(16, 16384), "width of the picture in pixels"),
        field(&P::tint, "tint", "colour of the ground: grey, or by height and depth"),
        field(&P::light_azimuth_deg, "light_azimuth_deg", "deg", between(-360, 360),
              "bearing of the main light, clockwise from north"),
        field(&P::light_elevation_deg, "light_elevation_deg", "deg", between(10, 80), "height of the lights"),
        field(&P::ambient, "ambient", "", between(0, 1), "how much valleys that see little sky are darkened"),
        field(&P::vertical_exaggeration, "vertical_exaggeration", "", between(0.01, 100),
              "heights are shaded times this; by default so that steep ground of this terrain looks steep"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }
};

/// The terrain from above, north up, width_px wide and as high as its shape asks for (1 to 16384 pixels). Throws
/// InvalidArgument for params out of range and heights that are not finite. About 150 ns a pixel, parallel.
Image relief(const HeightField& terrain, const ReliefParams& params, const RunContext& run);

/// dry_below_sea() of the terrain on the grid of a picture, 1 or 0; an empty grid where there is none.
Grid<uint8_t> picture_dry(const HeightField& terrain, const HeightField& picture,
                          const std::optional<double>& min_sea_m2, const RunContext& run);

/// The least heights of a picture's sea and of its land.
struct LowestGround {
  double sea_m = 0.0;   ///< 0 without sea
  double land_m = 0.0;  ///< below 0 where dry ground lies so low
};
LowestGround lowest_ground(const HeightField& picture, const Grid<uint8_t>& dry);

/// The terrain resampled to square pixels of a picture `width_px` wide.
HeightField picture_terrain(const HeightField& terrain, int width_px, const RunContext& run);

/// A tint under a relief shading (1: level): shadows turn a little blue, lights a little warm.
Rgb shaded(Rgb tint, float shade);

}  // namespace seamount::render

namespace seamount {
template <>
struct Choices<render::ReliefTint> {
  static constexpr std::array<std::string_view, 2> names = {"grey", "height"};
};
}  // namespace seamount

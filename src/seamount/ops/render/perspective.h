// render.perspective: a picture of a terrain from a point of view, with sun, sky, water and ground materials.
//
// Rays from the pixels' corners meet the height field in a pyramid of maxima (tracer.h); a pixel whose corners see one
// smooth surface is shaded once from mip-mapped forms, any other by nine rays of its own. Shadows and openness to the
// sky are found for the whole terrain first (light.h). The sea has one level; a terrain whose border is mostly under
// water lies in an endless sea, any other is cut out as a block.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"
#include "seamount/model/layer_borders.h"
#include "seamount/ops/render/materials.h"

namespace seamount::render {

/// What lies around the terrain.
enum class Surround { automatic, sea, block };

struct PerspectiveParams {
  int width_px = 1280;
  int height_px = 720;
  double camera_azimuth_deg = 205.0;
  double camera_elevation_deg = 25.0;
  double distance = 1.0;
  std::optional<double> target_x_m;
  std::optional<double> target_y_m;
  double field_of_view_deg = 35.0;
  double vertical_exaggeration = 1.0;
  double sun_azimuth_deg = 285.0;
  double sun_elevation_deg = 30.0;
  double haze = 1.0;
  double exposure = 1.0;
  bool water = true;
  double water_level_m = 0.0;
  double water_clarity = 1.0;
  Surround surround = Surround::automatic;
  double tree_line_m = 2000.0;
  double snow_line_m = 4500.0;
  Style style = Style::natural;
  LayerBorders layers;

  static constexpr auto fields() {
    using P = PerspectiveParams;
    return std::tuple(
        field(&P::width_px, "width_px", "", between(16, 8192), "width of the picture in pixels"),
        field(&P::height_px, "height_px", "", between(16, 8192), "height of the picture in pixels"),
        field(&P::camera_azimuth_deg, "camera_azimuth_deg", "deg", between(-360, 360),
              "bearing of the camera from the target, clockwise from north"),
        field(&P::camera_elevation_deg, "camera_elevation_deg", "deg", between(1, 89),
              "height of the camera above the horizon as seen from the target"),
        field(&P::distance, "distance", "", between(0.02, 10),
              "distance from the target; 1 shows the whole terrain, 0.5 is half as far"),
        field(&P::target_x_m, "target_x_m", "m", {}, "where to look, east; by default the middle of the land"),
        field(&P::target_y_m, "target_y_m", "m", {}, "where to look, north; by default the middle of the land"),
        field(&P::field_of_view_deg, "field_of_view_deg", "deg", between(5, 100), "angle of view from top to bottom"),
        field(&P::vertical_exaggeration, "vertical_exaggeration", "", between(0.1, 20), "heights are drawn times this"),
        field(&P::sun_azimuth_deg, "sun_azimuth_deg", "deg", between(-360, 360),
              "bearing of the sun, clockwise from north"),
        field(&P::sun_elevation_deg, "sun_elevation_deg", "deg", between(2, 89), "height of the sun over the horizon"),
        field(&P::haze, "haze", "", between(0, 5), "haze with distance; 0 is clear"),
        field(&P::exposure, "exposure", "", between(0.1, 10), "brightness of the picture"),
        field(&P::water, "water", "fill the ground below the water level"),
        field(&P::water_level_m, "water_level_m", "m", between(-12000, 9000), "height of the water's surface"),
        field(&P::water_clarity, "water_clarity", "", between(0.05, 5),
              "how far one sees in water, 1 in clear tropical water"),
        field(&P::surround, "surround", "what lies around the terrain"),
        field(&P::tree_line_m, "tree_line_m", "m", between(1, 9000), "height over the water where forest ends"),
        field(&P::snow_line_m, "snow_line_m", "m", between(-1000, 20000), "height over the water where snow stays"),
        field(&P::style, "style", "what the ground is made of: natural, or three layers by height in a style"),
        field(&P::layers, "layers", "borders of the style's layers, as heights over the water"));
  }
};

/// Draws the terrain; labels (may be null) say where beach, lagoon and reef are. Heights in metres, any size from 1
/// x 1. Throws InvalidArgument for params out of range and heights that are not finite, IncompatibleInputs for labels
/// of another size. About 1 us a pixel plus 40 ns a cell (up to 2048 x 2048 cells are kept), parallel.
Image perspective(const HeightField& terrain, const LabelMap* labels, const PerspectiveParams& params,
                  const RunContext& run);

}  // namespace seamount::render

namespace seamount {
template <>
struct Choices<render::Surround> {
  static constexpr std::array<std::string_view, 3> names = {"automatic", "sea", "block"};
};
}  // namespace seamount

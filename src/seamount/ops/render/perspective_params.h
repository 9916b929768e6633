// Parameters of render.perspective (perspective.h).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/layer_borders.h"
#include "seamount/ops/render/climate.h"
#include "seamount/ops/render/materials.h"
#include "seamount/ops/render/view_params.h"

namespace seamount::render {

/// What lies around the terrain.
enum class Surround { automatic, sea, block };

struct PerspectiveParams {
  int width_px = 1280;
  int height_px = 720;
  CameraParams camera;
  SunParams sun;
  double vertical_exaggeration = 1.0;
  double haze = 1.0;
  double exposure = 1.0;
  bool water = true;
  double water_level_m = 0.0;
  double water_clarity = 1.0;
  Surround surround = Surround::automatic;
  ClimateParams climate;
  std::optional<double> tree_line_m;
  std::optional<double> snow_line_m;
  Rock rock = Rock::automatic;
  Style style = Style::natural;
  LayerBorders layers;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = PerspectiveParams;
    return std::tuple(
        field(&P::width_px, "width_px", "", between(16, 8192), "width of the picture in pixels"),
        field(&P::height_px, "height_px", "", between(16, 8192), "height of the picture in pixels"),
        field(&P::camera, "camera", "from where to look"), field(&P::sun, "sun", "where the light comes from"),
        field(&P::vertical_exaggeration, "vertical_exaggeration", "", between(0.1, 20), "heights are drawn times this"),
        field(&P::haze, "haze", "", between(0, 5), "haze with distance; 0 is clear"),
        field(&P::exposure, "exposure", "", between(0.1, 10), "brightness of the picture"),
        field(&P::water, "water", "fill the ground below the water level"),
        field(&P::water_level_m, "water_level_m", "m", between(-12000, 9000), "height of the water's surface"),
        field(&P::water_clarity, "water_clarity", "", between(0.05, 5),
              "how far one sees in water, 1 in clear tropical water"),
        field(&P::surround, "surround", "what lies around the terrain"),
        field(&P::climate, "climate", "what grows on the land, in the natural style"),
        field(&P::tree_line_m, "tree_line_m", "m", between(1, 9000),
              "height over the water where forest ends; by default as usual for the latitude"),
        field(&P::snow_line_m, "snow_line_m", "m", between(-1000, 20000),
              "height over the water where snow stays; by default as usual for the latitude"),
        field(&P::rock, "rock", "bare rock in the natural style; automatic is basalt in a warm sea, else granite"),
        field(&P::style, "style", "what the ground is made of: natural, or three layers by height in a style"),
        field(&P::layers, "layers", "borders of the style's layers, as heights over the water"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }

  static constexpr std::array kFormerNames = {FormerName{"camera_azimuth_deg", "camera.azimuth_deg"},
                                              FormerName{"camera_elevation_deg", "camera.elevation_deg"},
                                              FormerName{"distance", "camera.distance"},
                                              FormerName{"target_x_m", "camera.target_x_m"},
                                              FormerName{"target_y_m", "camera.target_y_m"},
                                              FormerName{"field_of_view_deg", "camera.field_of_view_deg"},
                                              FormerName{"sun_azimuth_deg", "sun.azimuth_deg"},
                                              FormerName{"sun_elevation_deg", "sun.elevation_deg"}};
};

}  // namespace seamount::render

template <>
struct seamount::Choices<seamount::render::Surround> {
  static constexpr std::array<std::string_view, 3> names = {"automatic", "sea", "block"};
};

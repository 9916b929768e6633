// From where and in which light a perspective picture is taken.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"

namespace seamount::render {

/// Ready-made cameras: from above; low over the land's outline; from within the deepest valley; around all land at one
/// distance, for turntables.
enum class CameraView { aerial, hero, canyon, turntable };

struct CameraParams {
  CameraView view = CameraView::aerial;
  std::optional<double> azimuth_deg;
  std::optional<double> elevation_deg;
  double distance = 1.0;
  std::optional<double> target_x_m;
  std::optional<double> target_y_m;
  std::optional<double> distance_m;
  double target_height_m = 0.0;
  std::optional<double> x_m;
  std::optional<double> y_m;
  double height_m = 20.0;
  std::optional<double> field_of_view_deg;

  static constexpr auto fields() {
    using P = CameraParams;
    return std::tuple(
        field(
            &P::view, "view",
            "aerial: from above, so that all fits; hero: low, against the sky; canyon: from within the deepest valley; "
            "turntable: around all land, at the same distance from every side"),
        field(&P::azimuth_deg, "azimuth_deg", "deg", between(-360, 360),
              "bearing of the camera from the target, clockwise from north; 205 by default, in a canyon along the "
              "valley"),
        field(&P::elevation_deg, "elevation_deg", "deg", between(-60, 89),
              "height of the camera above the horizon as seen from the target; by default 25, hero 7, turntable 30"),
        field(&P::distance, "distance", "", between(0.02, 10),
              "distance from the target over that at which all just fits: 0.5 is half as far"),
        field(&P::target_x_m, "target_x_m", "m", {},
              "where to look, east; by default the middle of the largest land or reef and what is near"),
        field(&P::target_y_m, "target_y_m", "m", {}, "where to look, north; by default the same"),
        field(&P::distance_m, "distance_m", "m", between(0.05, 1e6),
              "metres from the target, which is then a place on the ground; under water the camera stays there; by "
              "default distance counts"),
        field(&P::target_height_m, "target_height_m", "m", between(-100, 9000),
              "with distance_m or x_m: height of the target over the ground"),
        field(&P::x_m, "x_m", "m", {}, "where the camera stands, east; with y_m, instead of a distance"),
        field(&P::y_m, "y_m", "m", {}, "where the camera stands, north"),
        field(&P::height_m, "height_m", "m", between(0.1, 50000),
              "with x_m and y_m: height of the camera over ground or water"),
        field(&P::field_of_view_deg, "field_of_view_deg", "deg", between(5, 100),
              "angle of view from top to bottom; by default 35, hero 28, canyon 60"));
  }
};

/// Ready-made light.
enum class Daylight { afternoon, morning, noon, evening };

struct SunParams {
  Daylight light = Daylight::afternoon;
  std::optional<double> azimuth_deg;
  std::optional<double> elevation_deg;

  static constexpr auto fields() {
    using P = SunParams;
    return std::tuple(field(&P::light, "light", "time of the day; azimuth_deg and elevation_deg overrule it"),
                      field(&P::azimuth_deg, "azimuth_deg", "deg", between(-360, 360),
                            "bearing of the sun, clockwise from north; afternoon 285, morning 80, evening 275, noon "
                            "towards the equator"),
                      field(&P::elevation_deg, "elevation_deg", "deg", between(2, 89),
                            "height of the sun over the horizon; afternoon 30, morning 14, noon 65, evening 6"));
  }
};

}  // namespace seamount::render

template <>
struct seamount::Choices<seamount::render::CameraView> {
  static constexpr std::array<std::string_view, 4> names = {"aerial", "hero", "canyon", "turntable"};
};
template <>
struct seamount::Choices<seamount::render::Daylight> {
  static constexpr std::array<std::string_view, 4> names = {"afternoon", "morning", "noon", "evening"};
};

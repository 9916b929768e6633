// Criteria of terrain.mask by the ground itself: height, depth, slope, aspect, curvature.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/ops/terrain/criterion_help.h"

namespace seamount::terrain {

/// Which bend of the ground.
enum class Bend { profile, plan, mean };

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::Bend> {
  static constexpr std::array<std::string_view, 3> names = {"profile", "plan", "mean"};
};

namespace seamount::terrain {

struct ByHeight {
  std::optional<double> low_m, high_m;
  double falloff_m = 20.0;
  bool invert = false;

  static constexpr std::string_view kTool = "height", kAbout = "selects by height above the sea";
  static constexpr auto fields() {
    using P = ByHeight;
    return std::tuple(field(&P::low_m, "low_m", "m", between(-12000, 9000), kLowHelp),
                      field(&P::high_m, "high_m", "m", between(-12000, 9000), kHighHelp),
                      field(&P::falloff_m, "falloff_m", "m", between(0, 20000), kFalloffHelp),
                      field(&P::invert, "invert", kInvertHelp));
  }
};

struct ByDepth {
  std::optional<double> low_m = 0.0;
  std::optional<double> high_m;
  double falloff_m = 5.0;
  bool invert = false;

  static constexpr std::string_view kTool = "depth", kAbout = "selects by depth below the sea";
  static constexpr auto fields() {
    using P = ByDepth;
    return std::tuple(field(&P::low_m, "low_m", "m", between(-9000, 12000), "least depth that is fully selected"),
                      field(&P::high_m, "high_m", "m", between(-9000, 12000), "greatest depth that is fully selected"),
                      field(&P::falloff_m, "falloff_m", "m", between(0, 20000), kFalloffHelp),
                      field(&P::invert, "invert", kInvertHelp));
  }
};

struct BySlope {
  std::optional<double> low_deg, high_deg;
  double falloff_deg = 5.0;
  double scale_m = 30.0;
  bool invert = false;

  static constexpr std::string_view kTool = "slope", kAbout = "selects by steepness";
  static constexpr auto fields() {
    using P = BySlope;
    return std::tuple(field(&P::low_deg, "low_deg", "deg", between(0, 90), kLowHelp),
                      field(&P::high_deg, "high_deg", "deg", between(0, 90), kHighHelp),
                      field(&P::falloff_deg, "falloff_deg", "deg", between(0, 90), kFalloffHelp),
                      field(&P::scale_m, "scale_m", "m", between(0, 1e5), "smaller forms are not looked at"),
                      field(&P::invert, "invert", kInvertHelp));
  }
};

struct ByAspect {
  double direction_deg = 0.0;
  double spread_deg = 60.0;
  double falloff_deg = 30.0;
  double level_deg = 2.0;
  double scale_m = 30.0;
  bool invert = false;

  static constexpr std::string_view kTool = "aspect", kAbout = "selects by the bearing that the ground faces";
  static constexpr auto fields() {
    using P = ByAspect;
    return std::tuple(
        field(&P::direction_deg, "direction_deg", "deg", between(-360, 360),
              "bearing that the ground faces, clockwise from north"),
        field(&P::spread_deg, "spread_deg", "deg", between(0, 360), "width of the bearings that are fully selected"),
        field(&P::falloff_deg, "falloff_deg", "deg", between(0, 180), kFalloffHelp),
        field(&P::level_deg, "level_deg", "deg", between(0, 90),
              "slope below which ground faces nowhere more and more"),
        field(&P::scale_m, "scale_m", "m", between(0, 1e5), "smaller forms are not looked at"),
        field(&P::invert, "invert", kInvertHelp));
  }
};

struct ByCurvature {
  Bend bend = Bend::mean;
  std::optional<double> low_per_km = 0.5;
  std::optional<double> high_per_km;
  double falloff_per_km = 0.5;
  double scale_m = 200.0;
  bool invert = false;

  static constexpr std::string_view kTool = "curvature", kAbout = "selects ridges or hollows";
  static constexpr auto fields() {
    using P = ByCurvature;
    return std::tuple(
        field(&P::bend, "bend", "along the line of fall (profile), along the contour (plan), or their mean"),
        field(&P::low_per_km, "low_per_km", "1/km", between(-1e4, 1e4),
              "least curvature that is fully selected: above 0 ridges, below 0 hollows, 1 a radius of a kilometre"),
        field(&P::high_per_km, "high_per_km", "1/km", between(-1e4, 1e4), kHighHelp),
        field(&P::falloff_per_km, "falloff_per_km", "1/km", between(0, 1e4), kFalloffHelp),
        field(&P::scale_m, "scale_m", "m", between(0, 1e5), "size of the forms that are looked at"),
        field(&P::invert, "invert", kInvertHelp));
  }
};

}  // namespace seamount::terrain

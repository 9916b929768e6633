// The tools of terrain.sculpt: what a stroke of the pen does to the ground.
#pragma once

#include <optional>
#include <string_view>
#include <tuple>
#include <variant>

#include "seamount/model/brush.h"

namespace seamount::terrain {

inline constexpr const char* kStrengthHelp = "how far it goes in the middle of the stroke: 0 not at all, 1 all the way";

struct RaiseTool : Brush {
  static constexpr std::string_view kTool = "raise", kAbout = "puts ground on";
  double height_m = 100.0;

  static constexpr auto fields() {
    return std::tuple_cat(Brush::fields(), std::tuple(field(&RaiseTool::height_m, "height_m", "m", between(0, 10000),
                                                            "what it adds in the middle of the stroke")));
  }
};

struct LowerTool : Brush {
  static constexpr std::string_view kTool = "lower", kAbout = "takes ground off";
  double depth_m = 100.0;

  static constexpr auto fields() {
    return std::tuple_cat(Brush::fields(), std::tuple(field(&LowerTool::depth_m, "depth_m", "m", between(0, 10000),
                                                            "what it takes off in the middle of the stroke")));
  }
};

struct SmoothTool : Brush {
  static constexpr std::string_view kTool = "smooth", kAbout = "takes off forms up to about the radius";
  double strength = 1.0;

  static constexpr auto fields() {
    return std::tuple_cat(Brush::fields(), std::tuple(field(&SmoothTool::strength, "strength", "", between(0, 1),
                                                            "share of the detail that goes")));
  }
};

struct FlattenTool : Brush {
  static constexpr std::string_view kTool = "flatten", kAbout = "brings ground to one height";
  std::optional<double> height_m;
  double strength = 1.0;

  static constexpr auto fields() {
    using P = FlattenTool;
    return std::tuple_cat(Brush::fields(),
                          std::tuple(field(&P::height_m, "height_m", "m", between(-12000, 9000),
                                           "the height; the ground's where the stroke begins if absent"),
                                     field(&P::strength, "strength", "", between(0, 1), kStrengthHelp)));
  }
};

struct RampTool : Brush {
  static constexpr std::string_view kTool = "ramp";
  static constexpr std::string_view kAbout = "makes an even slope from where the stroke begins to where it ends";
  std::optional<double> start_m;
  std::optional<double> end_m;
  double strength = 1.0;

  static constexpr auto fields() {
    using P = RampTool;
    return std::tuple_cat(Brush::fields(),
                          std::tuple(field(&P::start_m, "start_m", "m", between(-12000, 9000),
                                           "height where the stroke begins; the ground's there if absent"),
                                     field(&P::end_m, "end_m", "m", between(-12000, 9000),
                                           "height where the stroke ends; the ground's there if absent"),
                                     field(&P::strength, "strength", "", between(0, 1), kStrengthHelp)));
  }
};

struct RoughenTool : Brush {
  static constexpr std::string_view kTool = "roughen", kAbout = "gives ground natural detail";
  double amplitude_m = 50.0;
  double wavelength_m = 600.0;

  static constexpr auto fields() {
    using P = RoughenTool;
    return std::tuple_cat(Brush::fields(),
                          std::tuple(field(&P::amplitude_m, "amplitude_m", "m", between(0, 10000),
                                           "how far ground goes up or down where it goes furthest"),
                                     field(&P::wavelength_m, "wavelength_m", "m", between(0.1, 1e6),
                                           "size of the largest forms; detail of half the size follows, and so on")));
  }
};

/// An eraser: what earlier strokes did is taken back.
struct EraseTool : Brush {
  static constexpr std::string_view kTool = "erase", kAbout = "brings back the ground as it came into the step";
  double strength = 1.0;

  static constexpr auto fields() {
    return std::tuple_cat(Brush::fields(), std::tuple(field(&EraseTool::strength, "strength", "", between(0, 1),
                                                            "share of the earlier strokes that goes")));
  }
};

/// In a recipe a stroke is written {"tool": "raise", "points": [[0, 0], [900, 400]], "radius_m": 300}.
using SculptStroke = std::variant<RaiseTool, LowerTool, SmoothTool, FlattenTool, RampTool, RoughenTool, EraseTool>;

}  // namespace seamount::terrain

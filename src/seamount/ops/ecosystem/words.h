// The words that expressions of a catalogue are made of (rules.h says what they mean), in the order of their columns.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace seamount::ecosystem {

enum class PlaceWord : size_t {
  height,
  depth,
  ground,
  slope_deg,
  gradient_x,
  gradient_y,
  current,
  current_x,
  current_y,
  x,
  y,
  age,
  iteration,
  water_level,
};

inline constexpr std::array<std::string_view, 14> kPlaceWords = {
    "height",    "depth",     "ground", "slope_deg", "gradient_x", "gradient_y", "current",
    "current_x", "current_y", "x",      "y",         "age",        "iteration",  "water_level"};

enum class ClassWord : size_t { distance, border, inside, normal_x, normal_y, curvature, screened };

inline constexpr std::array<std::string_view, 7> kClassWords = {"distance", "border",    "inside",  "normal_x",
                                                                "normal_y", "curvature", "screened"};

inline constexpr std::string_view kNoiseWord = "noise";

}  // namespace seamount::ecosystem

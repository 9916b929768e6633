// What an object does to its surroundings (P3 sec. 1.6): to materials, to the ground, to the current; and what it is on
// a label map.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"

namespace seamount {

/// Deposition or absorption of a material: rate on the skeleton, falling off as exp(-d^2 / (2 radius^2)) with the
/// distance d (eq. 1.35).
struct Exchange {
  std::string material;
  double rate_1_s = 1.0;
  double radius_m = 10.0;
  bool operator==(const Exchange&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&Exchange::material, "material", "one of the catalogue's"),
        field(&Exchange::rate_1_s, "rate_1_s", "1/s", between(0, 1e9), "concentration given or taken in a second"),
        field(&Exchange::radius_m, "radius_m", "m", between(1e-3, 1e6), "deviation of the falloff from the skeleton"));
  }
};

enum class HeightShape : unsigned char { none, cone, dome, bump, plateau, ridge, cylinder, island, carve };
template <>
struct Choices<HeightShape> {
  static constexpr std::array<std::string_view, 9> names = {"none",  "cone",     "dome",   "bump", "plateau",
                                                            "ridge", "cylinder", "island", "carve"};
};

enum class HeightGroup : unsigned char { grounded, platform, altitude, surface };
template <>
struct Choices<HeightGroup> {
  static constexpr std::array<std::string_view, 4> names = {"grounded", "platform", "altitude", "surface"};
};

/// The coarse height function of an object (sec. 1.6.2), a function of the distance to its skeleton.
struct HeightEffect {
  HeightShape shape = HeightShape::none;
  HeightGroup group = HeightGroup::surface;
  double height_m = 1.0;
  double width_m = 10.0;
  double slope = 0.5;
  double roughness_m = 0.0;
  bool operator==(const HeightEffect&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&HeightEffect::shape, "shape",
              "cone, dome, bump (Gaussian), plateau, ridge, cylinder, island, carve (down into the ground)"),
        field(
            &HeightEffect::group, "group",
            "grounded: heights over z = 0, and platform: over the water level, both joined by the smooth maximum; "
            "altitude: over the water level, joined among themselves by the smooth minimum (eq. 1.47); surface: added"),
        field(&HeightEffect::height_m, "height_m", "m", between(-20000, 20000),
              "of its top: over z = 0, over the water level, over the ground; carve: depth of the cut"),
        field(&HeightEffect::width_m, "width_m", "m", between(1e-3, 1e7),
              "of its foot at the level that it is measured from; points: its diameter"),
        field(&HeightEffect::slope, "slope", "", between(1e-3, 100), "of its flanks beyond, as rise over run"),
        field(&HeightEffect::roughness_m, "roughness_m", "m", between(0, 1e5),
              "by how much noise moves its outline to and fro, in forms of six times that size and smaller"));
  }
};

enum class CurrentShape : unsigned char { scale, twist, grab, obstacle, waves };
template <>
struct Choices<CurrentShape> {
  static constexpr std::array<std::string_view, 5> names = {"scale", "twist", "grab", "obstacle", "waves"};
};

/// One primitive of the current around an object (sec. 1.6.3).
struct CurrentEffect {
  CurrentShape shape = CurrentShape::scale;
  double speed_m_s = 0.1;
  double radius_m = 10.0;
  double poisson_ratio = 0.45;
  double downstream_m = 0.0;
  double left_m = 0.0;
  bool operator==(const CurrentEffect&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(
            &CurrentEffect::shape, "shape",
            "regularised Kelvinlets: scale pushes away, twist turns counter-clockwise, grab drags downstream or along "
            "a curve; shore: the flow around the outline of a region"),
        field(&CurrentEffect::speed_m_s, "speed_m_s", "m/s", between(-100, 100), "the largest that it adds"),
        field(&CurrentEffect::radius_m, "radius_m", "m", between(1e-3, 1e6),
              "epsilon of the Kelvinlet; reach of a region's flow"),
        field(&CurrentEffect::poisson_ratio, "poisson_ratio", "", between(0, 0.5),
              "of grabs: 0.5 neither gathers nor spreads"),
        field(&CurrentEffect::downstream_m, "downstream_m", "m", between(-1e6, 1e6),
              "points: it acts so far downstream"),
        field(&CurrentEffect::left_m, "left_m", "m", between(-1e6, 1e6),
              "points: and so far to the left of the current"));
  }
};

enum class LabelChoice : unsigned char { none, mountain, beach, lagoon, reef, abyss };
template <>
struct Choices<LabelChoice> {
  static constexpr std::array<std::string_view, 6> names = {"none", "mountain", "beach", "lagoon", "reef", "abyss"};
};

/// What the object is on the label map of fig. 1.45.
struct LabelEffect {
  LabelChoice region = LabelChoice::none;
  double width_m = 0.0;
  bool operator==(const LabelEffect&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&LabelEffect::region, "region", "none: it does not show"),
                      field(&LabelEffect::width_m, "width_m", "m", between(0, 1e6),
                            "breadth of points and curves; regions: so far beyond their outline"));
  }
};

}  // namespace seamount

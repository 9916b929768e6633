// How a catalogue names what its objects look like: {"shape": "branching_coral", "height_m": 0.8, "variants": 5}.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount {

enum class ThingForm : unsigned char {
  rock,
  pebble,
  arch,
  branching_coral,
  massive_coral,
  table_coral,
  foliose_coral,
  sea_fan,
  sponge,
  palm,
  broadleaf,
  conifer,
  shrub,
  mangrove,
  seagrass,
  kelp,
  file,  ///< a mesh of the user's
};

template <>
struct Choices<ThingForm> {
  static constexpr std::array<std::string_view, 17> names = {
      "rock",     "pebble", "arch", "branching_coral", "massive_coral", "table_coral", "foliose_coral",
      "sea_fan",  "sponge", "palm", "broadleaf",       "conifer",       "shrub",       "mangrove",
      "seagrass", "kelp",   "file"};
};

struct ThingParams {
  ThingForm shape = ThingForm::rock;
  FilePath file;
  std::optional<double> height_m;
  std::optional<double> width_m;
  int variants = 5;
  double size_variation = 0.2;
  std::optional<double> lean;
  Colour colour;
  bool operator==(const ThingParams&) const = default;

  static constexpr auto fields() {
    using P = ThingParams;
    return std::tuple(
        field(&P::shape, "shape", "what it looks like; file: a mesh of your own"),
        field(&P::file, "file", "shape file: a GLB or OBJ file in metres, y up, its foot at the origin"),
        field(&P::height_m, "height_m", "m", between(0.005, 500),
              "height of a thing of size 1; by default what is usual for the shape, or what the file has"),
        field(&P::width_m, "width_m", "m", between(0.005, 500),
              "width of a thing of size 1; by default in proportion to its height"),
        field(&P::variants, "variants", "", between(1, 64), "different models of it"),
        field(&P::size_variation, "size_variation", "", between(0, 0.6), "deviation of the sizes around 1, as a share"),
        field(&P::lean, "lean", "", between(0, 1),
              "how far it stands along the ground's normal: 0 upright, 1 square to the slope; by default as the shape "
              "does"),
        field(&P::colour, "colour", "its main colour; black: the shape's own"));
  }
};

}  // namespace seamount

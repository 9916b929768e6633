// Criteria of terrain.mask by place: regions, areas, lines, noise, and the values of another field.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/terrain/criterion_help.h"

namespace seamount::terrain {

struct ByRegion {
  Region region = Region::beach;
  std::optional<double> low_m;
  std::optional<double> high_m = 0.0;
  double falloff_m = 100.0;
  bool invert = false;

  static constexpr std::string_view kTool = "region", kAbout = "selects by distance from a region of the label map";
  static constexpr auto fields() {
    using P = ByRegion;
    return std::tuple(
        field(&P::region, "region", "region of the label map to whose border the distance is measured"),
        field(&P::low_m, "low_m", "m", between(-1e7, 1e7),
              "least distance from the region that is fully selected, negative inside; no limit if absent"),
        field(&P::high_m, "high_m", "m", between(-1e7, 1e7), "greatest distance; 0: the region itself"),
        field(&P::falloff_m, "falloff_m", "m", between(0, 1e7), kFalloffHelp),
        field(&P::invert, "invert", kInvertHelp));
  }
};

struct ByArea {
  std::vector<Polygon> polygons;
  std::string feature;
  std::optional<double> low_m;
  std::optional<double> high_m = 0.0;
  double falloff_m = 100.0;
  bool invert = false;

  static constexpr std::string_view kTool = "area", kAbout = "selects drawn areas, or by distance from their border";
  static constexpr auto fields() {
    using P = ByArea;
    return std::tuple(
        field(&P::polygons, "polygons",
              "areas drawn here; none: those of the input 'drawing', or what its lines enclose"),
        field(&P::feature, "feature", "name of the area in the drawing; empty: all of them"),
        field(&P::low_m, "low_m", "m", between(-1e7, 1e7),
              "least distance from the border that is fully selected, negative inside; no limit if absent"),
        field(&P::high_m, "high_m", "m", between(-1e7, 1e7), "greatest distance; 0: the areas themselves"),
        field(&P::falloff_m, "falloff_m", "m", between(0, 1e7), "feathering beyond the limits"),
        field(&P::invert, "invert", kInvertHelp));
  }
};

struct ByLine {
  Polyline points;
  std::optional<double> low_m;
  std::optional<double> high_m = 0.0;
  double falloff_m = 200.0;
  bool invert = false;

  static constexpr std::string_view kTool = "line", kAbout = "selects by distance from a drawn line";
  static constexpr auto fields() {
    using P = ByLine;
    return std::tuple(
        field(&P::points, "points", "a line drawn here; none: the lines of the input 'drawing'"),
        field(&P::low_m, "low_m", "m", between(0, 1e7), "least distance that is fully selected; no limit if absent"),
        field(&P::high_m, "high_m", "m", between(0, 1e7), "greatest distance that is fully selected"),
        field(&P::falloff_m, "falloff_m", "m", between(0, 1e7), kFalloffHelp),
        field(&P::invert, "invert", kInvertHelp));
  }
};

struct ByNoise {
  double coverage = 0.5;
  double softness = 0.5;
  double wavelength_m = 1000.0;
  int octaves = 5;
  double gain = 0.5;
  bool invert = false;

  static constexpr std::string_view kTool = "noise", kAbout = "selects patches of noise";
  static constexpr auto fields() {
    using P = ByNoise;
    return std::tuple(
        field(&P::coverage, "coverage", "", between(0, 1), "share of the ground that is selected, about"),
        field(&P::softness, "softness", "", between(0, 1), "0: patches with sharp borders; 1: soft clouds"),
        field(&P::wavelength_m, "wavelength_m", "m", between(0.01, 1e7), "size of the largest patches"),
        field(&P::octaves, "octaves", "", between(1, 16), "layers of detail, each of half the size"),
        field(&P::gain, "gain", "", between(0.1, 0.95), "strength of each layer over the one before"),
        field(&P::invert, "invert", kInvertHelp));
  }
};

struct ByValue {
  std::optional<double> low, high;
  double falloff = 0.0;
  bool invert = false;

  static constexpr std::string_view kTool = "value", kAbout = "selects by the input 'values'";
  static constexpr auto fields() {
    using P = ByValue;
    return std::tuple(field(&P::low, "low", "least value of the input 'values' that is fully selected"),
                      field(&P::high, "high", "greatest value that is fully selected"),
                      field(&P::falloff, "falloff", "", at_least(0), kFalloffHelp),
                      field(&P::invert, "invert", kInvertHelp));
  }
};

}  // namespace seamount::terrain

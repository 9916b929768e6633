// Parameters of the beds under a terrain (lithology.h). Heights and places are those of the rock before any uplift.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount::erosion {

/// One bed of rock.
struct BedParams {
  std::string name;
  double thickness_m = 50;
  double hardness = 1;

  static constexpr auto fields() {
    using P = BedParams;
    return std::tuple(
        field(&P::name, "name", "what the bed is called, for those who read the recipe"),
        field(&P::thickness_m, "thickness_m", "m", between(0.1, 10000),
              "thickness across the bed; beds of 0.1 to 10, caps of 10 to 100"),
        field(&P::hardness, "hardness", "", between(0.01, 1000),
              "how many times as hard as `erodibility` says: shale 0.2 to 0.5, a cap 3 to 10; four times as hard "
              "stands twice as steep"));
  }
};

/// A fault that has moved the beds.
struct FaultParams {
  Polyline trace;
  double dip_deg = 70;
  double throw_m = 100;

  static constexpr auto fields() {
    using P = FaultParams;
    return std::tuple(
        field(&P::trace, "trace", "m", {},
              "line of the fault at the height `top_m`, at least two points; it goes on straight beyond its ends"),
        field(&P::dip_deg, "dip_deg", "deg", between(10, 90), "dip of the fault to the right of its trace"),
        field(&P::throw_m, "throw_m", "m", between(-10000, 10000),
              "how far the beds to the right of the trace have gone down; negative: up"));
  }
};

struct LithologyParams {
  std::vector<BedParams> beds;
  bool repeat = true;
  double top_m = 0;
  double top_x_m = 0;
  double top_y_m = 0;
  double dip_deg = 0;
  double strike_deg = 0;
  double fold_height_m = 0;
  double fold_wavelength_m = 6000;
  std::optional<double> fold_axis_deg;
  double thickness_variation = 0;
  std::vector<FaultParams> faults;

  static constexpr auto fields() {
    using P = LithologyParams;
    return std::tuple(
        field(&P::beds, "beds", "beds of rock from the top down; none: rock without beds"),
        field(&P::repeat, "repeat", "the sequence repeats above and below; else its first and last bed have no end"),
        field(&P::top_m, "top_m", "m", between(-12000, 12000), "height of the first bed's top, before any uplift"),
        field(&P::top_x_m, "top_x_m", "m", between(-1e7, 1e7), "where it has that height, east"),
        field(&P::top_y_m, "top_y_m", "m", between(-1e7, 1e7), "where it has that height, north"),
        field(&P::dip_deg, "dip_deg", "deg", between(0, 85),
              "tilt of the beds: mesas 0, cuestas 2 to 15, hogbacks over 30"),
        field(&P::strike_deg, "strike_deg", "deg", between(-360, 360),
              "bearing of level lines on the beds, clockwise from north; they dip to the right of it"),
        field(&P::fold_height_m, "fold_height_m", "m", between(0, 5000), "height of arches over troughs; 0: no folds"),
        field(&P::fold_wavelength_m, "fold_wavelength_m", "m", between(10, 1e6), "from one arch to the next"),
        field(&P::fold_axis_deg, "fold_axis_deg", "deg", between(-360, 360),
              "bearing of arches and troughs; by default the strike"),
        field(&P::thickness_variation, "thickness_variation", "", between(0, 0.9),
              "share by which beds thicken and thin from place to place"),
        field(&P::faults, "faults", "faults that have moved the beds"));
  }
};

}  // namespace seamount::erosion

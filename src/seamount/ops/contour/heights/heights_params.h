// Parameters of contour.heights (heights.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/contour/heights/distribution.h"

namespace seamount::contour {

enum class Summits : uint8_t { by_size, equal };
enum class Outlines : uint8_t { follow, loose };
enum class Spikes : uint8_t { cut, keep };

struct HeightsParams {
  Landform landform = Landform::mountain;
  std::vector<double> histogram;
  Curve density;
  std::optional<double> min_m;
  std::optional<double> max_m;
  std::optional<double> measure_above_m;
  Summits summits = Summits::by_size;
  Outlines outlines = Outlines::follow;
  Spikes spikes = Spikes::cut;
  std::optional<double> basin_depth_m;
  double shore_slope_deg = 12.0;

  static constexpr auto fields() {
    using P = HeightsParams;
    return std::tuple(
        field(&P::landform, "landform", "distribution of heights that makes such a landform"),
        field(&P::histogram, "histogram", "", at_least(0),
              "instead: how much ground lies at each height, in equal steps from lowest to highest"),
        field(&P::density, "density", "", at_least(0),
              "instead: a drawn density of heights, x from 0 (lowest) to 1 (highest)"),
        field(&P::min_m, "min_m", "m", between(-12000, 9000),
              "lowest height; derived: the terrain's, else the lowest outline's, else 0"),
        field(&P::max_m, "max_m", "m", between(-12000, 9000),
              "highest height; derived: the terrain's, else a twelfth of the land's width above the highest outline"),
        field(&P::measure_above_m, "measure_above_m", "m", between(-12000, 9000),
              "measure only the terrain's cells from this height up; derived: all"),
        field(&P::summits, "summits", "by_size: wider ground rises higher; equal: every summit reaches the top"),
        field(&P::outlines, "outlines",
              "follow: contours at their heights follow the outlines; loose: as the growth is"),
        field(&P::spikes, "spikes",
              "cut: ground far steeper than the rest is cut back to a slope; keep: every height of the distribution "
              "stays where the growth has it"),
        field(&P::basin_depth_m, "basin_depth_m", "m", between(0.01, 9000),
              "depth of basins below their outlines; derived: half way down to the next outline, less in narrow ones"),
        field(&P::shore_slope_deg, "shore_slope_deg", "deg", between(0.1, 60),
              "how steeply the sea floor falls away from the coast, ever less below 1200 m"));
  }

  static constexpr std::array kFormerNames = {FormerName{"needles", "spikes"}};
};

}  // namespace seamount::contour

template <>
struct seamount::Choices<seamount::contour::Summits> {
  static constexpr std::array<std::string_view, 2> names = {"by_size", "equal"};
};
template <>
struct seamount::Choices<seamount::contour::Outlines> {
  static constexpr std::array<std::string_view, 2> names = {"follow", "loose"};
};
template <>
struct seamount::Choices<seamount::contour::Spikes> {
  static constexpr std::array<std::string_view, 2> names = {"cut", "keep"};
};

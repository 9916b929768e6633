// contour.heights: heights for a grown network, from a distribution of heights and the heights of its outlines.
//
// Source: P2 sec. 3.3, 4.4, fig. 8 and 23. Growth gives an order; heights are the distribution's quantiles in that
// order, so that another distribution needs no other growth. Where we depart or the paper is silent:
//  - An outline whose height its author gave is a contour of that height: nodes just inside are not lower, nodes just
//    outside not higher. Ground between two such outlines takes the part of the distribution between their heights.
//    Outlines without height lie where the distribution puts them; all regions of one depth between the same outlines
//    with height rise together, as in the paper.
//  - Nodes beside an outline are put in the order of their distance to it, so that the contour follows the outline
//    itself and not the unevenness of the nodes (`outlines: follow`).
//  - Of several summits the one on the wider ground is the highest (P2 sec. 6.1), in proportion to the ground's width.
//  - Places that growth leaves to the very end would be towers, however narrow: ground steeper than twice the usual
//  slope
//    is cut back (`needles: cut`), except in regions whose peak is given. About a hundredth of the ground moves.
//  - Outside the regions the ground falls from the nearest outline: a sea floor, where that is at 0.
//  - Basins fall from their outline by basin_depth_m.
// Each node but those outside and a basin's deepest has a lower neighbour, as far as the growth gave it one.
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/heights/distribution.h"

namespace seamount::contour {

enum class Summits : uint8_t { by_size, equal };
enum class Outlines : uint8_t { follow, loose };
enum class Needles : uint8_t { cut, keep };

struct HeightsParams {
  Landform landform = Landform::mountain;
  std::vector<double> histogram;
  Curve density;
  std::optional<double> min_m;
  std::optional<double> max_m;
  std::optional<double> measure_above_m;
  Summits summits = Summits::by_size;
  Outlines outlines = Outlines::follow;
  Needles needles = Needles::cut;
  std::optional<double> basin_depth_m;
  double shore_slope_deg = 5.0;

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
        field(&P::needles, "needles",
              "cut: ground far steeper than the rest is cut back to a slope; keep: every height of the distribution "
              "stays where the growth has it"),
        field(&P::basin_depth_m, "basin_depth_m", "m", between(0.01, 9000),
              "depth of basins below their outlines; derived: half way down to the next outline"),
        field(&P::shore_slope_deg, "shore_slope_deg", "deg", between(0.1, 60),
              "how steeply the ground falls outside the regions"));
  }
};

/// The network with heights; everything else stays. `terrain`, if there, gives the distribution. Throws
/// InvalidArgument for a distribution of no ground, min_m not below max_m, an outline's height outside the range;
/// IncompatibleInputs for a network that was not grown. n log n, about 1 us and 100 bytes per node; serial but for the
/// distances to outlines.
Tin heights(Tin tin, const HeightField* terrain, const HeightsParams& params, const RunContext& run);

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
struct seamount::Choices<seamount::contour::Needles> {
  static constexpr std::array<std::string_view, 2> names = {"cut", "keep"};
};

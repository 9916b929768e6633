// island.build: from the plan and the profile of an island to its height field and label map.
//
// Source: P0 sec. 1.4.1, eq. 1.1 and 1.2, Algorithm 1 part 1, and the low-amplitude noise of its last paragraph.
// Departures: plans of any form (coordinate.h); heights in metres; irregular detail of coasts below what the plan
// shows; gullies that run down the slopes (geom/water/gullies.h), since a surface of revolution with noise does not
// drain.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/scalar/curve.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/island/shape.h"

namespace seamount::island {

/// How a drawn curve runs between its knots.
enum class Interpolation { monotone_cubic, linear };

}  // namespace seamount::island

template <>
struct seamount::Choices<seamount::island::Interpolation> {
  static constexpr std::array<std::string_view, 2> names = {"monotone_cubic", "linear"};
};

namespace seamount::island {

struct BuildParams {
  FilePath coast;
  std::string feature;
  std::vector<PolarOutline> outlines;
  std::vector<Polygon> areas;
  Vec2 centre;
  double irregularity = 0.35;
  std::optional<double> beach_m;
  std::optional<double> lagoon_m;
  std::optional<double> reef_m;
  std::optional<double> slope_m;
  Curve profile;
  Interpolation interpolation = Interpolation::monotone_cubic;
  std::optional<double> peak_m;
  std::optional<double> floor_m;
  std::optional<double> coast_detail_m;
  double smoothing = 0.6;
  double massif = 0.5;
  double relief = 1.0;
  std::optional<double> valley_spacing_m;
  double noise_m = 3.0;
  double noise_wavelength_m = 600.0;

  static constexpr auto fields() {
    using P = BuildParams;
    return std::tuple(
        field(&P::coast, "coast",
              "coastline to build on: GeoJSON, GeoPackage or Shapefile, or a painted label image (.png)"),
        field(&P::feature, "feature", "name of the feature in the coast file; empty: all of them"),
        field(&P::outlines, "outlines", "m", at_least(0),
              "polar outlines around the centre: the coast alone, or mountain, beach, lagoon, reef, abyss"),
        field(&P::areas, "areas", "drawn polygons of the coast"),
        field(&P::centre, "centre", "centre of polar outlines and of random islands"),
        field(&P::irregularity, "irregularity", "", between(0, 1),
              "how much the coast of a random island departs from a circle"),
        field(&P::beach_m, "beach_m", "m", between(0.1, 1e5),
              "width of the beach, inside the coast; derived from the land's area if absent"),
        field(&P::lagoon_m, "lagoon_m", "m", between(0.1, 1e6), "width of the lagoon; derived if absent"),
        field(&P::reef_m, "reef_m", "m", between(0.1, 1e6), "width of the reef; derived if absent"),
        field(&P::slope_m, "slope_m", "m", between(0.1, 1e6),
              "width of the slope down to the sea floor; derived if absent"),
        field(
            &P::profile, "profile", "m", between(-12000, 12000),
            "height over the region coordinate 0 (summit) to 5 (sea floor); derived from peak_m and floor_m if empty"),
        field(&P::interpolation, "interpolation", "how the profile runs between its knots"),
        field(&P::peak_m, "peak_m", "m", between(0, 9000),
              "height of the summit; derived from the land's area if absent"),
        field(&P::floor_m, "floor_m", "m", between(-12000, -1), "height of the sea floor; derived if absent"),
        field(&P::coast_detail_m, "coast_detail_m", "m", between(0, 1e5),
              "size of bays and headlands below what the plan shows; derived if absent"),
        field(&P::smoothing, "smoothing", "", between(0, 1),
              "how much creases between far parts of the outlines are softened"),
        field(&P::massif, "massif", "", between(0, 1),
              "how unevenly the mountains rise: 0 one smooth cone, 1 several massifs"),
        field(&P::relief, "relief", "", between(0, 2), "depth of the valleys that run down the slopes"),
        field(&P::valley_spacing_m, "valley_spacing_m", "m", between(1, 1e6),
              "distance between the largest valleys; derived if absent"),
        field(&P::noise_m, "noise_m", "m", between(0, 1000), "height of the fine noise"),
        field(&P::noise_wavelength_m, "noise_wavelength_m", "m", between(0.1, 1e6),
              "size of the largest bumps of the fine noise"));
  }
};

struct Island {
  HeightField terrain;
  LabelMap labels;
  ScalarField coordinate;  ///< x~ in [0, 5]
};

/// Heights over x~ in metres: params.profile, or the shape of an old volcanic island scaled to peak and floor.
Curve profile_curve(const Plan& plan, const BuildParams& params);

/// Builds the island of a plan on a frame. `params` gives everything but the plan (its coast, outlines, areas and
/// widths are not looked at again). Throws InvalidArgument for params out of range, a profile whose knots do not
/// ascend, and a coast that touches the frame's edge. Parallel; about 13 bytes per cell with the result, and lattices
/// of at most 4096 x 4096.
Island build(const Plan& plan, const BuildParams& params, const GridFrame& frame, Seed seed, const RunContext& run);

}  // namespace seamount::island

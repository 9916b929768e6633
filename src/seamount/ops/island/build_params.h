// Parameters of island.build (build.h).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/presets.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/island/summit_params.h"
#include "seamount/ops/island/width_params.h"

namespace seamount::island {

/// How a drawn curve runs between its knots.
enum class Interpolation { monotone_cubic, linear };

/// Forms smaller than the plan and the profile say.
struct BuildDetail {
  std::optional<double> coast_m;
  std::optional<double> valley_spacing_m;
  double width_variation = 0.35;
  double smoothing = 0.6;
  double noise_m = 3.0;
  double noise_wavelength_m = 600.0;

  static constexpr auto fields() {
    using P = BuildDetail;
    return std::tuple(field(&P::coast_m, "coast_m", "m", between(0, 1e5),
                            "size of bays and headlands below what the plan shows; none on drawn coasts if absent"),
                      field(&P::valley_spacing_m, "valley_spacing_m", "m", between(1, 1e6),
                            "distance between the largest valleys; derived if absent"),
                      field(&P::width_variation, "width_variation", "", between(0, 1),
                            "how uneven beach, lagoon and reef are along the coast, wide in bays, narrow off "
                            "headlands, where the plan is one coast"),
                      field(&P::smoothing, "smoothing", "", between(0, 1),
                            "how much creases between far parts of the outlines are softened"),
                      field(&P::noise_m, "noise_m", "m", between(0, 1000), "height of the fine noise"),
                      field(&P::noise_wavelength_m, "noise_wavelength_m", "m", between(0.1, 1e6),
                            "size of the largest bumps of the fine noise"));
  }
};

struct BuildParams {
  FilePath coast;
  std::string feature;
  std::string layer;
  std::string crs;
  std::vector<PolarOutline> outlines;
  std::vector<Polygon> areas;
  Vec2 centre;
  double irregularity = 0.35;
  std::optional<double> peak_m;
  std::optional<double> floor_m;
  std::vector<Summit> summits;
  double massif = 0.5;
  double relief = 1.0;
  Curve profile;
  Interpolation interpolation = Interpolation::monotone_cubic;
  GivenWidths widths;
  BuildDetail detail;

  static constexpr auto fields() {
    using P = BuildParams;
    return std::tuple(
        field(&P::coast, "coast",
              "coastline to build on: areas or closed lines in a GeoJSON, GeoPackage, Shapefile or SVG, or a painted "
              "label image (.png)"),
        field(&P::feature, "feature", "name of the feature in the coast file; empty: all of them"),
        field(&P::layer, "layer", "layer of the coast file; empty: the first with areas, else with lines"),
        field(&P::crs, "crs",
              "coordinate system of the coast file where it says none or a wrong one: EPSG:32627, or local for metres"),
        field(&P::outlines, "outlines", "m", at_least(0),
              "polar outlines around the centre: the coast alone, or mountain, beach, lagoon, reef, abyss"),
        field(&P::areas, "areas", "drawn polygons of the coast"),
        field(&P::centre, "centre", "centre of polar outlines and of random islands"),
        field(&P::irregularity, "irregularity", "", between(0, 1),
              "how much the coast of a random island departs from a circle"),
        field(&P::peak_m, "peak_m", "m", between(0, 9000),
              "height of the highest summit, to the metre; derived from the land's width if absent"),
        field(&P::floor_m, "floor_m", "m", between(-12000, -1), "height of the sea floor; derived if absent"),
        field(&P::summits, "summits",
              "summits with their heights; lobes of the land without one have their own, as high as their width lets "
              "them be"),
        field(&P::massif, "massif", "", between(0, 1),
              "how unevenly the mountains rise: 0 smooth cones, 1 several massifs"),
        field(&P::relief, "relief", "", between(0, 2), "depth of the valleys that run down the slopes"),
        field(
            &P::profile, "profile", "m", between(-12000, 12000),
            "height over the region coordinate 0 (summit) to 5 (sea floor); derived from peak_m and floor_m if empty"),
        field(&P::interpolation, "interpolation", "how the profile runs between its knots"),
        field(&P::widths, "widths", "widths of the regions around the mountains, where the plan is one coast"),
        field(&P::detail, "detail", "forms smaller than the plan and the profile say"));
  }

  static constexpr auto presets() {
    using P = BuildParams;
    return std::array{
        preset<P>("hotspot", "a young shield of lava: smooth, round, with a narrow fringing reef",
                  [](P& p) {
                    p.irregularity = 0.2;
                    p.massif = 0.1;
                    p.relief = 0.35;
                    p.widths.lagoon_m = 80;
                    p.widths.reef_m = 120;
                  }),
        preset<P>("high", "jagged peaks over deep valleys in green slopes, and a lagoon",
                  [](P& p) {
                    p.massif = 1;
                    p.relief = 1.8;
                    p.peak_m = 1100;
                  }),
        preset<P>("old", "the low rest of a sunken island in a wide shallow lagoon inside its reef", [](P& p) {
          p.irregularity = 0.5;
          p.massif = 1;
          p.relief = 1.4;
          p.peak_m = 300;
          p.widths.lagoon_m = 1300;
          p.widths.reef_m = 400;
        })};
  }

  static constexpr std::array kFormerNames = {FormerName{"beach_m", "widths.beach_m"},
                                              FormerName{"lagoon_m", "widths.lagoon_m"},
                                              FormerName{"reef_m", "widths.reef_m"},
                                              FormerName{"slope_m", "widths.slope_m"},
                                              FormerName{"coast_detail_m", "detail.coast_m"},
                                              FormerName{"valley_spacing_m", "detail.valley_spacing_m"},
                                              FormerName{"smoothing", "detail.smoothing"},
                                              FormerName{"noise_m", "detail.noise_m"},
                                              FormerName{"noise_wavelength_m", "detail.noise_wavelength_m"}};
};

}  // namespace seamount::island

template <>
struct seamount::Choices<seamount::island::Interpolation> {
  static constexpr std::array<std::string_view, 2> names = {"monotone_cubic", "linear"};
};

// Parameters of reef.grow (grow.h). Heights are metres about sea level, bearings clockwise from north.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/reef/aggregate.h"

namespace seamount::reef {

/// How the kernels of many colonies go together: `union_`, the kernels over the distance to the outline of all
/// colonies, never above one; `sum` adds them up as P4 eq. 1 and 2.
enum class Combine { union_, sum };

/// `saturating`: reefs grow by metres until they reach the sea's surface; `proportional`: to the height of the base
/// over datum_m, without bound (P4).
enum class Lift { saturating, proportional };

struct GrowParams {
  double lattice_m = 70.0;
  int particles = 0;
  int max_steps = 200000;
  double stickiness = 1.0;
  Launch launch = Launch::anywhere;
  Polyline kernels;
  Polyline line;
  double line_cover = 0.7;
  double segment_m = 2500.0;
  std::optional<double> kernel_height_m;
  int random_kernels = 0;
  double current = 0.0;
  double current_to_deg = 300.0;
  std::optional<double> habitat_low_m;
  std::optional<double> habitat_high_m;
  std::optional<double> margin_m;
  std::optional<double> kernel_radius_m;
  double irregularity = 1.0;
  Combine combine = Combine::union_;
  Lift lift = Lift::saturating;
  double w0 = 1.0;
  double w1 = 1.0;
  double w2 = 1.0;
  double k = 10.0;
  double k1 = 5.0;
  double k1_jitter = 0.25;
  double k2 = 4.0;
  double lift_m = 60.0;
  double rim_m = 2.5;
  double flat_m = -1.8;
  double crest_m = -0.4;
  double lagoon_m = -9.0;
  double lagoon_fill = 0.8;
  double relief_m = 1.0;
  double grooves_m = 3.0;
  double swell_from_deg = 130.0;
  double lee_rim = 0.35;
  int cays = 3;
  double cay_m = 3.0;
  std::optional<double> lagoon_gap_m;
  double datum_m = -250.0;
  double blur_m = 0.0;
  bool normalise = false;
  double normalised_low_m = -250.0;
  double normalised_high_m = 250.0;

  static constexpr auto fields() {
    using P = GrowParams;
    const Range height = between(-12000, 9000);
    const Range share = between(0, 1);
    return std::tuple(
        field(&P::lattice_m, "lattice_m", "m", between(0.1, 1e6),
              "cell of the lattice on which particles walk and settle"),
        field(&P::particles, "particles", "", between(0, 4000000), "particles to shoot; 0: one for 8 cells of habitat"),
        field(&P::max_steps, "max_steps", "", between(1, 1000000000), "steps after which a walk is given up"),
        field(&P::stickiness, "stickiness", "", between(0.001, 1),
              "chance to settle at a touch; low values give thick, rounded reefs"),
        field(&P::launch, "launch", "where walks start: on a ring around the reef, or anywhere on the lattice"),
        field(&P::kernels, "kernels", "m", {},
              "places where growth starts; the middle of the sea if there is no kernel"),
        field(&P::line, "line", "m", {}, "a line along which growth starts, such as a shelf edge"),
        field(&P::line_cover, "line_cover", "", share, "share of lines where growth starts; the rest are passes"),
        field(&P::segment_m, "segment_m", "m", between(1, 1e7), "length of a stretch of line with its pass"),
        field(&P::kernel_height_m, "kernel_height_m", "m", height, "growth starts along the contour at this height"),
        field(&P::random_kernels, "random_kernels", "", between(0, 100000),
              "kernels at random places of the habitat, or of the input 'start'"),
        field(&P::current, "current", "", share, "how strongly currents carry the particles"),
        field(&P::current_to_deg, "current_to_deg", "deg", between(-360, 360), "bearing to which currents flow"),
        field(&P::habitat_low_m, "habitat_low_m", "m", height,
              "no growth where the ground is lower; no bound if absent"),
        field(&P::habitat_high_m, "habitat_high_m", "m", height,
              "no growth where the ground is higher; none if absent"),
        field(&P::margin_m, "margin_m", "m", between(0, 1e7),
              "no growth this near to the terrain's edge, in bays up to twice that; 3 kernel radii if absent"),
        field(&P::kernel_radius_m, "kernel_radius_m", "m", between(0.1, 1e6),
              "radius of the kernels around particles; 1.465 lattice_m if absent, as in P4"),
        field(&P::irregularity, "irregularity", "", share,
              "how far particles, radii and outlines depart from the lattice"),
        field(&P::combine, "combine", "how kernels go together: as one united outline, or summed (P4)"),
        field(&P::lift, "lift", "saturating: up to the sea's surface; proportional: to the base over datum_m (P4)"),
        field(&P::w0, "w0", "", between(0, 10), "weight of the base terrain over datum_m"),
        field(&P::w1, "w1", "", between(0, 10), "weight of the normal kernels"),
        field(&P::w2, "w2", "", between(0, 10), "weight of the log-normal kernels at the edge"),
        field(&P::k, "k", "", between(2, 40), "exponent of the normal kernel: steepness of the reef's sides"),
        field(&P::k1, "k1", "", between(1.1, 40), "the rim lies 1 / k1 of the radius inside the edge"),
        field(&P::k1_jitter, "k1_jitter", "", between(0, 0.9), "random share of k1, which makes the rim uneven"),
        field(&P::k2, "k2", "", between(2, 40),
              "exponent of the log-normal kernel: how squarely the rim stands; 10 in P4"),
        field(&P::lift_m, "lift_m", "m", between(0, 5000),
              "height that the normal kernel lifts the ground (saturating)"),
        field(&P::rim_m, "rim_m", "m", between(0, 500), "height that the edge kernel lifts the rim (saturating)"),
        field(&P::flat_m, "flat_m", "m", height, "height at which the normal lift saturates: the reef flat"),
        field(&P::crest_m, "crest_m", "m", height, "height at which the rim saturates: the reef crest"),
        field(&P::lagoon_m, "lagoon_m", "m", height, "floor of lagoons within wide or crowded reefs"),
        field(&P::lagoon_fill, "lagoon_fill", "", share, "how far sand fills the water between reefs, up to lagoon_m"),
        field(&P::relief_m, "relief_m", "m", between(0, 50), "unevenness of reef flats and lagoon floors"),
        field(&P::grooves_m, "grooves_m", "m", between(0, 50), "depth of spurs and grooves on the fore reef"),
        field(&P::swell_from_deg, "swell_from_deg", "deg", between(-360, 360), "bearing from which the swell comes"),
        field(&P::lee_rim, "lee_rim", "", share, "share of the rim's height that is left in the lee of the swell"),
        field(&P::cays, "cays", "", between(0, 10000), "islets of sand on the reef"),
        field(&P::cay_m, "cay_m", "m", between(0, 50), "height of the islets"),
        field(&P::lagoon_gap_m, "lagoon_gap_m", "m", between(0, 1e6),
              "water behind passes up to this width is labelled lagoon; 2 kernel radii if absent"),
        field(&P::datum_m, "datum_m", "m", height, "the zero of P4's heights: w0 and proportional lifts count from it"),
        field(&P::blur_m, "blur_m", "m", between(0, 1e5), "blur of the result; 0: none"),
        field(&P::normalise, "normalise", "stretch the result to normalised_low_m ... normalised_high_m"),
        field(&P::normalised_low_m, "normalised_low_m", "m", height, "lowest height after normalising"),
        field(&P::normalised_high_m, "normalised_high_m", "m", height, "highest height after normalising"));
  }
};

}  // namespace seamount::reef

template <>
struct seamount::Choices<seamount::reef::Combine> {
  static constexpr std::array<std::string_view, 2> names = {"union", "sum"};
};
template <>
struct seamount::Choices<seamount::reef::Lift> {
  static constexpr std::array<std::string_view, 2> names = {"saturating", "proportional"};
};

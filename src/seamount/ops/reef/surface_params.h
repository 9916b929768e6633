// Parameters of the ground that a reef makes (kernels.h, surface.h): the kernels, how far they lift it, sand, and
// detail. Heights are metres about sea level.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"

namespace seamount::reef {

/// How the kernels of many colonies go together: `union_`, the kernels over the distance to the outline of all
/// colonies, never above one; `sum` adds them up as P4 eq. 1 and 2.
enum class Combine { union_, sum };

/// `saturating`: reefs grow by metres until they reach the sea's surface; `proportional`: to the height of the base
/// over datum_m, without bound (P4).
enum class Lift { saturating, proportional };

struct KernelParams {
  std::optional<double> radius_m;
  Combine combine = Combine::union_;
  double k = 10.0;
  double k1 = 5.0;
  double k1_jitter = 0.25;
  double k2 = 4.0;

  static constexpr auto fields() {
    using P = KernelParams;
    return std::tuple(
        field(&P::radius_m, "radius_m", "m", between(0.1, 1e6),
              "radius of the kernels around particles; 1.465 lattice_m if absent, as in P4"),
        field(&P::combine, "combine", "how kernels go together: as one united outline, or summed (P4)"),
        field(&P::k, "k", "", between(2, 40),
              "exponent of the normal kernel: steepness of the sides of the aggregate and of summed reefs"),
        field(&P::k1, "k1", "", between(1.1, 40), "the rim lies 1 / k1 of the radius inside the edge"),
        field(&P::k1_jitter, "k1_jitter", "", between(0, 0.9), "random share of k1, which makes the rim uneven"),
        field(&P::k2, "k2", "", between(2, 40),
              "exponent of the log-normal kernel: how squarely the rim stands; 10 in P4"));
  }
};

struct HeightParams {
  Lift mode = Lift::saturating;
  double flat_m = -1.8;
  double crest_m = -0.4;
  double lift_m = 60.0;
  double rim_m = 2.5;
  double lee_rim = 0.35;
  double fore_slope_deg = 26.0;
  double lee_slope_deg = 14.0;
  double flat_width_m = 350.0;
  double w0 = 1.0;
  double w1 = 1.0;
  double w2 = 1.0;
  double datum_m = -250.0;

  static constexpr auto fields() {
    using P = HeightParams;
    const Range height = between(-12000, 9000);
    return std::tuple(
        field(&P::mode, "mode", "saturating: up to the sea's surface; proportional: to the base over datum_m (P4)"),
        field(&P::flat_m, "flat_m", "m", height, "height at which the normal lift saturates: the reef flat"),
        field(&P::crest_m, "crest_m", "m", height, "height at which the rim saturates: the reef crest"),
        field(&P::lift_m, "lift_m", "m", between(0, 5000),
              "height by which a reef lifts the ground at most (saturating)"),
        field(&P::rim_m, "rim_m", "m", between(0, 500), "height that the edge kernel lifts the rim (saturating)"),
        field(&P::lee_rim, "lee_rim", "", between(0, 1),
              "share of the rim's height that is left in the lee of the swell"),
        field(&P::fore_slope_deg, "fore_slope_deg", "deg", between(2, 70),
              "slope of the fore reef to windward (saturating, union)"),
        field(&P::lee_slope_deg, "lee_slope_deg", "deg", between(2, 70), "slope of the reef's side in the lee"),
        field(&P::flat_width_m, "flat_width_m", "m", between(1, 1e5),
              "width of the flat to windward, half of that in the lee; behind it wide reefs hold a lagoon"),
        field(&P::w0, "w0", "", between(0, 10), "weight of the base terrain over datum_m"),
        field(&P::w1, "w1", "", between(0, 10), "weight of the normal kernels"),
        field(&P::w2, "w2", "", between(0, 10), "weight of the log-normal kernels at the edge"),
        field(&P::datum_m, "datum_m", "m", height,
              "the zero of P4's heights: w0 and proportional lifts count from it"));
  }
};

struct SandParams {
  double lagoon_m = -9.0;
  double fill = 0.8;
  double knolls_per_km2 = 25.0;
  int cays = 3;
  double cay_m = 3.0;

  static constexpr auto fields() {
    using P = SandParams;
    return std::tuple(
        field(&P::lagoon_m, "lagoon_m", "m", between(-12000, 9000), "floor of lagoons within wide or crowded reefs"),
        field(&P::fill, "fill", "", between(0, 1), "how far sand fills the water between reefs, up to lagoon_m"),
        field(&P::knolls_per_km2, "knolls_per_km2", "1/km2", between(0, 1000),
              "patch reefs on the floors of lagoons, many small and few large"),
        field(&P::cays, "cays", "", between(0, 10000), "islets of sand on the lee of flats; wide ones carry plants"),
        field(&P::cay_m, "cay_m", "m", between(0, 50), "height of the larger islets"));
  }
};

/// Passes: where the tide that fills a lagoon keeps corals from closing it.
struct PassParams {
  double least_km2 = 0.2;
  double spacing_m = 16000.0;
  std::optional<double> width_m;
  std::optional<double> depth_m;

  static constexpr auto fields() {
    using P = PassParams;
    return std::tuple(field(&P::least_km2, "least_km2", "km2", between(0, 1e9),
                            "lagoons at least this large have a pass to the open sea (saturating)"),
                      field(&P::spacing_m, "spacing_m", "m", between(100, 1e7),
                            "length of barrier for one pass: longer ones have more"),
                      field(&P::width_m, "width_m", "m", between(10, 5000),
                            "width of passes; if absent 100 to 1000 by the size of the lagoon"),
                      field(&P::depth_m, "depth_m", "m", between(4, 200),
                            "depth of passes, never below the ground on which the reef stands; if absent 10 to 60 by "
                            "the size of the lagoon"));
  }
};

struct DetailParams {
  double relief_m = 1.0;
  double grooves_m = 3.0;
  double groove_spacing_m = 80.0;

  static constexpr auto fields() {
    using P = DetailParams;
    return std::tuple(
        field(&P::relief_m, "relief_m", "m", between(0, 50), "unevenness of reef flats and lagoon floors"),
        field(&P::grooves_m, "grooves_m", "m", between(0, 50),
              "depth of spurs and grooves on the windward fore reef, where cells resolve them"),
        field(&P::groove_spacing_m, "groove_spacing_m", "m", between(1, 5000), "distance from spur to spur"));
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

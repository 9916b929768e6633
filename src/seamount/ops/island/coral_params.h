// Parameters of island.coral (coral.h).
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "seamount/base/fields.h"

namespace seamount::island {

/// A cross-section of the reef: heights, and where across it they lie (0: inner border, 1: outer border).
struct ReefSection {
  double crest_m = -2.0;
  double back_m = -20.0;
  double abyss_m = -100.0;
  double back_start = 0.0;
  double back_end = 0.5;
  double crest_start = 0.75;
  double crest_end = 0.8;
  double abyss_start = 1.0;
  double fore_reef_slope_deg = 28.0;

  static constexpr auto fields() {
    using P = ReefSection;
    return std::tuple(
        field(&P::crest_m, "crest_m", "m", between(-200, 50), "height of the reef crest"),
        field(&P::back_m, "back_m", "m", between(-500, 50), "height of the back reef and of the lagoon's floor"),
        field(&P::abyss_m, "abyss_m", "m", between(-5000, 50), "height at the foot of the fore reef"),
        field(&P::back_start, "back_start", "", between(0, 1),
              "where the back reef starts across the reef (0: inner border, 1: outer border)"),
        field(&P::back_end, "back_end", "", between(0, 1), "where the back reef ends and rises to the crest"),
        field(&P::crest_start, "crest_start", "", between(0, 1), "where the crest starts"),
        field(&P::crest_end, "crest_end", "", between(0, 1), "where the crest ends and the fore reef falls"),
        field(&P::abyss_start, "abyss_start", "", between(0, 1), "where the fore reef reaches abyss_m"),
        field(&P::fore_reef_slope_deg, "fore_reef_slope_deg", "deg", between(0, 80),
              "slope on which the fore reef goes on beyond the reef; 0: stays at abyss_m"));
  }
};

struct CoralParams {
  double subsidence = 0.0;
  double swell_from_deg = 130.0;
  double exposure = 0.5;
  int passes = -1;
  double pass_width_m = 350.0;
  double pass_depth_m = 18.0;
  double lagoon_relief_m = 5.0;
  double islets = 0.3;
  double islet_m = 3.0;
  double blend_m = 1.0;
  std::optional<double> floor_m;
  bool relabel = true;
  ReefSection section;

  static constexpr auto fields() {
    using P = CoralParams;
    return std::tuple(
        field(&P::subsidence, "subsidence", "", between(0, 1),
              "share of its height over the sea floor by which the island has sunk"),
        field(&P::swell_from_deg, "swell_from_deg", "deg", between(-360, 360), "bearing from which the swell comes"),
        field(&P::exposure, "exposure", "", between(0, 1),
              "how much the reef differs to windward, narrow, high and with long islets, and to leeward"),
        field(&P::passes, "passes", "", between(-1, 200),
              "channels through the reef, the first off the largest rivers; -1: one for 16 km of reef, at least two"),
        field(&P::pass_width_m, "pass_width_m", "m", between(1, 1e5), "width of a pass"),
        field(&P::pass_depth_m, "pass_depth_m", "m", between(0, 500), "depth of a pass"),
        field(&P::lagoon_relief_m, "lagoon_relief_m", "m", between(0, 100),
              "height of patch reefs and hollows on the lagoon's floor"),
        field(&P::islets, "islets", "", between(0, 1), "share of the reef that carries islets of sand"),
        field(&P::islet_m, "islet_m", "m", between(0, 20), "height of the islets"),
        field(&P::blend_m, "blend_m", "m", between(0.001, 100),
              "how much the smooth maximum of island and reef exceeds both where they are equal"),
        field(&P::floor_m, "floor_m", "m", between(-12000, 9000),
              "height that does not sink; the lowest of the terrain if absent"),
        field(&P::relabel, "relabel",
              "label what has sunk below the sea and the deep back reef as lagoon, and beaches along the new coast"),
        field(&P::section, "section", "heights across the reef"));
  }

  static constexpr std::array kFormerNames = {FormerName{"crest_m", "section.crest_m"},
                                              FormerName{"back_m", "section.back_m"},
                                              FormerName{"abyss_m", "section.abyss_m"},
                                              FormerName{"back_start", "section.back_start"},
                                              FormerName{"back_end", "section.back_end"},
                                              FormerName{"crest_start", "section.crest_start"},
                                              FormerName{"crest_end", "section.crest_end"},
                                              FormerName{"abyss_start", "section.abyss_start"},
                                              FormerName{"fore_reef_slope_deg", "section.fore_reef_slope_deg"}};
};

}  // namespace seamount::island

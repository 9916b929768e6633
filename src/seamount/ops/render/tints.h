// Height and depth tints of maps. Land: the Swiss and National Geographic habit of muted greens at the coast that turn
// to straw, tan and a pale grey on the peaks ("the higher the lighter", Imhof, Cartographic Relief Presentation, 1982,
// ch. 13). Sea: pale turquoise over lagoons to deep blue ("the deeper the darker"). Both start from one shore colour,
// so they meet without a jump. Neighbouring knots are about the same step of Oklab lightness apart and the ramp is
// mixed in Oklab, so equal steps of height look equal.
#pragma once

#include <string>
#include <vector>

#include "seamount/ops/render/colour.h"

namespace seamount::render {

/// The scale of a map: which height gets which tint.
class TintScale {
 public:
  /// For heights between lowest_m and highest_m (any order of magnitude, finite). Land starts at sea level unless all
  /// of it is far above; depths are scaled by the logarithm, so that lagoons and abyss both show.
  TintScale(double lowest_m, double highest_m);
  /// With land that lies lower than the sea: least heights of sea (0: none) and land (infinite: none).
  TintScale(double lowest_sea_m, double lowest_land_m, double highest_m);

  /// Tint of a height, linear light. From a table: cheap.
  /// `land`: whatever its height.
  Rgb tint(float height_m, bool land = false) const;
  /// Tint at a place of the legend's bar.
  Rgb bar_tint(double place) const;
  /// Place on the legend's bar, 0 at the lowest and 1 at the highest.
  double bar_place(double height_m, bool land = false) const;
  /// Inverse of bar_place.
  double bar_height(double place) const;

  struct Tick {
    double height_m, place;
  };
  /// Round heights inside the scale that are at least `gap` of the bar apart, from its lower end on.
  std::vector<Tick> ticks(double gap) const;

  bool has_sea() const { return deepest_m_ > 0.0; }
  bool has_land() const { return top_m_ > base_m_; }

 private:
  double deepest_m_ = 0.0;  ///< > 0: depth of the darkest blue
  double base_m_ = 0.0;     ///< height of the first land tint; below 0 where land lies lower than the sea
  double top_m_ = 0.0;      ///< height of the last
  double sea_share_ = 0.0;  ///< part of the bar that is sea
  std::vector<Rgb> table_;  ///< along the bar
};

/// Tint of a lake by its depth.
Rgb lake_tint(float depth_m);

/// Colours of the five regions of a label map, linear light, in the order of model/label_map.h.
Rgb region_colour(int region);

/// The largest of 1, 2, 5 times a power of ten that is not above x. REQUIRES: x > 0.
double round_down_nice(double x);

/// A height for people: thousands apart ("1 500"), a true minus sign.
std::string height_text(double height_m);

}  // namespace seamount::render

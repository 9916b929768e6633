// The field that skeletons are fitted to (P3 sec. 1.5.2): what an object of a class finds at a place.
#pragma once

#include <cmath>
#include <functional>
#include <span>

#include "seamount/model/drawn.h"

namespace seamount::geom {

/// values[i] = Gamma(places[i]), metres in, any unit out. Called from one thread, seldom and with many places: a call
/// is dear, a place is cheap. Must be a function of the place alone. What is not finite is unfit: outside the domain,
/// say.
using FieldAtPlaces = std::function<void(std::span<const Vec2> places, std::span<double> values)>;

/// The slope along one axis from the values `reach` after and before a place whose own is `here`: central, one-sided
/// beside an unfit place, 0 between two.
inline double slope_between(double before, double here, double after, double reach) {
  const bool has_before = std::isfinite(before), has_after = std::isfinite(after);
  if (has_before && has_after) return (after - before) / (2.0 * reach);
  if (has_after) return (after - here) / reach;
  return has_before ? (here - before) / reach : 0.0;
}

}  // namespace seamount::geom

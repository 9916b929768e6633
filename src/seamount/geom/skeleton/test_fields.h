// Fields for the tests of skeletons.
#pragma once

#include <cmath>
#include <limits>

#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/skeleton/field.h"

namespace seamount::geom {

template <class Function>
FieldAtPlaces field_of(Function function) {
  return [function](std::span<const Vec2> places, std::span<double> values) {
    for (size_t i = 0; i < places.size(); ++i) values[i] = function(places[i]);
  };
}

/// Noise in a square of `side` from the origin, unfit outside.
inline FieldAtPlaces noise_in_square(Seed seed, double wavelength_m, double side) {
  const Fbm shape = {.wavelength_m = wavelength_m, .octaves = 4};
  return field_of([=](Vec2 p) {
    if (p.x < 0.0 || p.y < 0.0 || p.x > side || p.y > side) return std::numeric_limits<double>::quiet_NaN();
    return 0.5 + fbm(seed, shape, p.x, p.y);
  });
}

}  // namespace seamount::geom

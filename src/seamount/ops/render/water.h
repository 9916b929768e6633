// Light that comes out of the sea: what the floor sends up through the water, what the water itself scatters, what the
// surface reflects of sky and sun, and foam.
//
// Body: R = R_deep + (A_floor - R_deep) exp(-K path), the shallow-water reflectance of Maritorena, Morel and Gentili,
// "Diffuse reflectance of oceanic shallow waters", Limnology and Oceanography 39, 1994, eq. 9, with a path down from
// the sun and up to the eye. Surface: mean Fresnel reflectance of a rough sea (Bruneton, Neyret and Holzschuch,
// "Real-time realistic ocean lighting", Eurographics 2010, eq. 18), glitter by the slope statistics of Cox and Munk
// (1954) with the waves that hide each other (their eq. 11; Smith 1967).
#pragma once

#include "seamount/ops/render/sky.h"

namespace seamount::render {

struct WaterPoint {
  Vec3 to_eye;
  float x = 0.0F, y = 0.0F;  ///< metres
  float footprint = 1.0F;    ///< metres
  float depth = 0.0F;        ///< metres of water along the vertical, below the refracted view
  Rgb floor;                 ///< albedo
  float sun = 1.0F, sky = 1.0F;
  float foam = 0.0F;     ///< share of the surface that is foam
  float shelter = 0.0F;  ///< 1 where neither swell nor long waves come
  float glint = 1.0F;    ///< share of the sun's road: running water mirrors banks and breaks it up
};

/// Share of light that survives a path of that many metres in clear tropical water; clarity 2 doubles how far one sees.
Rgb water_transmittance(float path_m, float clarity);

/// Reflectance of a floor under water seen from right above, with the sun at its height: for textures.
Rgb reflectance_from_above(Rgb floor, float depth, float sun_height, float clarity);

/// Rivers: shallow and a little turbid over gravel.
inline constexpr float kRiverDepth_m = 1.5F;
Rgb river_bed();

/// Cosine of the refracted ray to the vertical in water for a ray in air with cosine `cosine`.
float refracted_cosine(float cosine);

/// Foam by depth: the wash on beaches, and where swell breaks. `breaking` and `exposed` in [0, 1]: whether the floor
/// drops into open water right here, and whether open water is near.
float foam_share(float x, float y, float footprint, float depth, float breaking, float exposed);

/// Sunlight that the waves' facets mirror to the eye, over that of a white card which faces the sun; compressed as film
/// does, so that the sun's road keeps its form: never above 0.36. `normal` is the tilt of the waves that are seen,
/// `variance` that of the slopes of the rest. REQUIRES: unit vectors, variance > 0.
float sun_glint(Vec3 to_eye, Vec3 normal, Vec3 to_sun, float variance);

Rgb water_light(const WaterPoint& point, const Sky& sky, float clarity);

}  // namespace seamount::render

// Light that comes from a place on the ground or on the water. Software renderers pay for every branch whether it is
// taken or not, so what a picture does not need is left out by the preprocessor:
//   PLANE     only water, also beyond the terrain
//   WATER     ground below 0 is under water
//   FINE      refraction, short waves, grain: for pictures at rest, and always where there is a graphics processor
//   SMOOTH    cells are larger than pixels
//   DETAIL    there is a window of finer ground
//   DRY       some ground below 0 is no sea
//   OVERLAY, CONTOURS
in vec3 place;
in float skirt;
uniform sampler2D surface, lit, noise, heights;
uniform vec3 eye;
uniform float cell_m, exaggeration, border_depth, pixel_angle, sun_path;
uniform vec2 half_size;
out vec4 result;

#ifdef SMOOTH
// Where cells are larger than pixels: a smooth surface through them (cubic B-spline by four taps), without their grid.
vec4 ground_at(sampler2D t, vec2 uv) {
  vec2 size = vec2(textureSize(t, 0)), at = uv * size - 0.5, whole = floor(at), f = at - whole;
  vec2 g = 1.0 - f, w0 = g * g * g / 6.0, w1 = (4.0 - 6.0 * f * f + 3.0 * f * f * f) / 6.0;
  vec2 w3 = f * f * f / 6.0, w2 = 1.0 - w0 - w1 - w3;
  vec2 low = w0 + w1, high = w2 + w3;
  vec2 a = (whole - 0.5 + w1 / low) / size, b = (whole + 1.5 + w3 / high) / size;
  return low.y * (low.x * textureLod(t, a, 0.0) + high.x * textureLod(t, vec2(b.x, a.y), 0.0)) +
         high.y * (low.x * textureLod(t, vec2(a.x, b.y), 0.0) + high.x * textureLod(t, b, 0.0));
}
#else
vec4 ground_at(sampler2D t, vec2 uv) { return texture(t, uv); }
#endif

#ifdef DETAIL
uniform sampler2D detail_surface, detail_lit;
uniform float detail_cell_m;

vec4 ground_of(sampler2D coarse, sampler2D fine, vec2 uv) {
  vec2 q = detail_at(uv);
  return mix(ground_at(coarse, uv), ground_at(fine, q), detail_weight(q));
}
vec4 surface_at(vec2 uv) { return ground_of(surface, detail_surface, uv); }
vec4 lit_at(vec2 uv) { return ground_of(lit, detail_lit, uv); }
#define GRAIN_M detail_cell_m
#else
vec4 surface_at(vec2 uv) { return ground_at(surface, uv); }
vec4 lit_at(vec2 uv) { return ground_at(lit, uv); }
#define GRAIN_M cell_m
#endif

vec3 wave(vec2 p, float wavelength) {
  vec4 t = texture(noise, p / (8.0 * wavelength));
  return vec3(t.ba * 2.0 - 1.0, t.r - 0.5);
}

#if defined(PLANE) || defined(WATER)
// `s` and `ground`: of the floor below; `outside`: 1 where the terrain is no longer known.
vec3 sea(vec2 uv, vec4 s, vec4 ground, vec3 to_eye, float far, vec3 level, float outside) {
  float under = sqrt(1.0 - (1.0 - to_eye.z * to_eye.z) / 1.777);
  float shore_depth = max(0.0, -s.a), depth = shore_depth;
#ifdef FINE
  // The floor is seen where the refracted ray meets it.
  vec2 aside = -to_eye.xy / (1.333 * under) * min(depth, 30.0);
  vec2 q = uv + aside * vec2(0.5, -0.5) / half_size;
  depth = max(0.0, -surface_at(q).a);
  ground.rgb = lit_at(q).rgb;
#endif
  vec3 deep = vec3(0.0024, 0.0185, 0.0500);
  vec3 floor_light = 1.6 * ground.rgb * ground.rgb;
  // Models of dry land have 0 for the sea: its depth is unknown, not nothing.
  float unknown = ramp(0.05, 0.0, abs(s.a)) * ramp(0.003, 0.0, abs(s.x) + abs(s.y));
  float path = depth * (1.0 / max(0.3, under) + sun_path) + 900.0 * max(outside, unknown);
  vec3 body = level * (deep + exp(-path * vec3(0.200, 0.0335, 0.0245)) * (floor_light - deep));
  // Long waves and short ones tilt the surface; what is too small to see is in the statistics.
  vec3 swell = wave(mat2(0.8, 0.6, -0.6, 0.8) * place.xy, 330.0);
  vec2 tilt = 0.045 * swell.xy;
  float breakers = swell.z;
#ifdef FINE
  vec3 chop = wave(mat2(0.28, 0.96, -0.96, 0.28) * place.xy, 31.0);
  tilt += 0.11 * chop.xy + 0.10 * wave(mat2(0.6, -0.8, 0.8, 0.6) * place.xy, 5.3).xy;
  breakers += 1.4 * chop.z;
#endif
  float shallow = max(max(outside, unknown), ramp(0.0, 3.0, depth));
  vec3 normal = normalize(vec3(-shallow * tilt, 1.0));
  float cosine = max(0.02, dot(normal, to_eye)), grazing = 1.0 - cosine;
  vec3 reflected = reflect(-to_eye, normal);
  reflected.z = max(0.06, reflected.z + 0.10);
  vec3 seen = mix(body, radiance(normalize(reflected)), 0.02 + 0.36 * grazing * grazing * grazing);
  // The sun's road: facets that mirror it, by the slopes of a breeze.
  vec3 half_way = normalize(to_eye + to_sun);
  float facing = max(0.2, dot(half_way, normal)), slope2 = 1.0 / (facing * facing) - 1.0;
  float variance = 0.010 + 0.008 * swell.z;
  float glint = 0.00075 * exp(-slope2 / variance) / (variance * max(0.08, cosine));
  seen += shallow * glint / (1.0 + 3.0 * glint) * sun_light;
  // Foam: the wash on beaches and the surf on reefs.
  float surf = ground.a * ramp(5.0, 0.8, shore_depth);
  float wash = (0.14 + 0.3 * surf) * ramp(1.3, 0.1, shore_depth + 1.2 * breakers);
  float foam = (1.0 - max(outside, unknown)) * max(wash, 0.9 * surf * clamp01(0.75 + 2.2 * breakers));
  return mix(seen, vec3(0.80) * level, 0.85 * foam * clamp01(0.9 + 1.6 * breakers));
}
#endif

#ifndef PLANE
vec3 land(vec4 s, vec4 ground, vec3 to_eye, float far, vec3 level) {
  vec3 seen = 2.0 * ground.rgb * ground.rgb;
#ifdef FINE
  // Grain that the cells are too coarse for, where the eye is near: crowns and stones, more on slopes.
  float near = ramp(1.8, 0.6, far * pixel_angle * 2.5 / GRAIN_M);
  float size = min(GRAIN_M, 90.0);
  vec3 grain = wave(mat2(0.8, 0.6, -0.6, 0.8) * place.xy, 0.55 * size) +
               0.7 * wave(mat2(0.28, 0.96, -0.96, 0.28) * place.xy, 0.13 * size) + 0.6 * wave(place.xy, 0.025 * size);
  float steep = min(1.0, length(s.xy));
  seen *= max(0.25, 1.0 + near * ((0.75 + 0.5 * steep) * grain.z + (0.30 + 0.35 * steep) * dot(grain.xy, normalize(to_sun.xy + 1e-4))));
#endif
  return seen * level * (1.0 + 0.12 * max(0.0, dot(to_eye, to_sun)));
}
#endif

void main() {
  vec2 uv = vec2(0.5 + 0.5 * place.x / half_size.x, 0.5 - 0.5 * place.y / half_size.y);
  vec3 to_eye = eye - place;
  float far = length(to_eye);
  to_eye /= far;
  vec3 level = max(0.02, to_sun.z) * sun_light + sky_light;
  vec4 s = surface_at(uv), ground = lit_at(uv);
#if defined(PLANE) && defined(DRY)
  if (uv == clamp(uv, 0.0, 1.0) && dry_at(uv) > 0.5) discard;
#endif
#ifdef PLANE
  float beyond = length(max(abs(place.xy) - half_size, 0.0)) / (2.0 * max(half_size.x, half_size.y));
  float outside = max(ramp(0.0, 0.12, beyond), step(1e-6, beyond) * ramp(-2.0, 0.0, s.a));  // no shore goes on
  vec3 light = sea(uv, s, ground, to_eye, far, level, outside);
#else
  float outside = 0.0;
  float change = max(fwidth(s.a), 1e-4);
  vec3 light = land(s, ground, to_eye, far, level);
#ifdef WATER
  float wet = clamp01(0.5 - (s.a - 0.02) / change);
#ifdef DRY
  wet *= step(dry_at(uv), 0.5);
#endif
  light = mix(light, sea(uv, s, ground, to_eye, far, level, 0.0), wet);
#endif
#endif
#ifdef OVERLAY
  // The light stays, the colour is the overlay's.
  vec4 over = overlay_at(uv);
  float bright = luminance(light) / luminance(level);
  light = mix(light, over.rgb * level * 0.5 * clamp(0.35 + 1.9 * bright / (bright + 0.3), 0.3, 1.7), over.a * (1.0 - step(0.001, outside)));
#endif
#if defined(CONTOURS) && !defined(PLANE)
  light = mix(light, contour_colour, contours(s.a, change) * 0.8);
#endif
  result = shown(tone_curve(hazed(light, -to_eye, far)));
}

// What is laid over the ground: coloured cells (labels, fields, pictures), steepness, height lines.
uniform sampler2D overlay;
uniform vec4 overlay_place;  // places of the ground (0 to 1) times zw plus xy
uniform float overlay_strength;
#ifdef FINE_OVERLAY
uniform sampler2D overlay_detail;  // the window of finer ground has a finer one, too
#endif
uniform float contour_m;  // 0: none
uniform vec3 contour_colour;

uniform float overlay_sharp;  // 1: cells are regions with borders, not values

// Regions between whose cells there are smooth borders without steps: of the four cells around, what has most weight.
vec4 regions(sampler2D t, vec2 q) {
  ivec2 last = textureSize(t, 0) - 1;
  vec2 at = q * vec2(last + 1) - 0.5, whole = floor(at), f = at - whole;
  ivec2 a = clamp(ivec2(whole), ivec2(0), last), b = clamp(ivec2(whole) + 1, ivec2(0), last);
  vec4 c[4] = vec4[4](texelFetch(t, a, 0), texelFetch(t, ivec2(b.x, a.y), 0), texelFetch(t, ivec2(a.x, b.y), 0), texelFetch(t, b, 0));
  float w[4] = float[4]((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
  vec4 sum = vec4(0.0);
  float all = 0.0;
  for (int i = 0; i < 4; ++i) {
    float share = 0.0;
    for (int j = 0; j < 4; ++j) share += w[j] * step(distance(c[i], c[j]), 1e-3);
    share *= share;
    share *= share;
    share = w[i] * share * share;
    sum += share * c[i];
    all += share;
  }
  return sum / max(all, 1e-6);
}

vec4 overlay_in(sampler2D t, vec2 q) { return overlay_sharp > 0.5 ? regions(t, q) : texture(t, q); }

vec4 overlay_at(vec2 p) {
  vec2 q = p * overlay_place.zw + overlay_place.xy;
  vec4 c = overlay_in(overlay, q);
#ifdef FINE_OVERLAY
  vec2 d = detail_at(p);
  c = mix(c, overlay_in(overlay_detail, d), detail_weight(d));
#endif
  vec2 inside = step(vec2(0.0), q) * step(q, vec2(1.0));
  // Square for the display's curve: near enough for legends, and cheap.
  vec3 colour = c.rgb / max(c.a, 1e-3);
  return vec4(colour * colour * (0.85 + 0.15 * colour), c.a * overlay_strength * inside.x * inside.y);
}

vec3 slope_colour(float tangent) {
  float degrees_up = degrees(atan(tangent));
  vec3 c = mix(vec3(0.78, 0.83, 0.74), vec3(0.93, 0.86, 0.52), ramp(3.0, 15.0, degrees_up));
  c = mix(c, vec3(0.92, 0.56, 0.28), ramp(12.0, 28.0, degrees_up));
  c = mix(c, vec3(0.74, 0.22, 0.22), ramp(26.0, 40.0, degrees_up));
  return linear(mix(c, vec3(0.36, 0.13, 0.30), ramp(38.0, 60.0, degrees_up)));
}

// Coverage of the height lines; each fifth is heavier. `change`: of the height over a pixel.
float contours(float height, float change) {
  float per = max(change, 1e-5) / contour_m;
  float at = height / contour_m;
  float line = abs(fract(at + 0.5) - 0.5) / per;
  float fifth = abs(fract(at / 5.0 + 0.5) - 0.5) * 5.0 / per;
  float crowded = ramp(0.45, 0.15, per), crowded_fifth = ramp(0.45, 0.15, per / 5.0);
  return max(0.55 * clamp01(1.1 - line) * crowded, 0.85 * clamp01(1.4 - fifth) * crowded_fifth);
}

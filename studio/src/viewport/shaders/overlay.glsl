// What is laid over the ground: coloured cells (labels, fields, pictures), steepness, height lines.
uniform sampler2D overlay;
uniform vec4 overlay_place;  // places of the ground (0 to 1) times zw plus xy
uniform float overlay_strength;
uniform float contour_m;  // 0: none
uniform vec3 contour_colour;

vec4 overlay_at(vec2 p) {
  vec2 q = p * overlay_place.zw + overlay_place.xy;
  vec4 c = texture(overlay, q);
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

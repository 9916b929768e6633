// The map: hypsometric tints under a relief shading, height lines, and what is laid over.
in vec2 uv;
uniform sampler2D surface, heights, tints;
uniform float cell_m, pixel_m;
uniform vec3 tint_scale;  // depth of the darkest blue, heights of the first and last tint of land
uniform vec3 paper;
uniform bool water;
uniform int ground_style;
out vec4 result;

#ifdef DETAIL
uniform sampler2D detail_surface;
#endif

float fine_height(sampler2D of, vec2 p) { return height_of(of, p * vec2(textureSize(of, 0))); }

vec3 tint(float height, bool flooded) {
  float sea = 0.5 - 0.5 * clamp01(log(1.0 + max(0.0, -height) / 12.0) / log(1.0 + tint_scale.x / 12.0));
  float land = 0.5 + 0.5 * clamp01((height - tint_scale.y) / max(1e-3, tint_scale.z - tint_scale.y));
  return linear(texture(tints, vec2(flooded ? sea : land, 0.5)).rgb);
}

vec3 shaded(vec3 colour, float shade) {
  if (shade < 1.0) return mix(colour * vec3(0.10, 0.115, 0.18), colour, pow(max(0.0, shade), 1.4));
  float more = (shade - 1.0) / (1.0 + 0.9 * (shade - 1.0));
  vec3 bright = (1.0 + 0.9 * more) * colour;
  return mix(bright, vec3(1.0, 0.985, 0.93), clamp01(0.9 * more * luminance(colour)));
}

void main() {
  vec2 clamped = clamp(uv, 0.0, 1.0);
  vec4 s = texture(surface, clamped);
  float texels = pixel_m / cell_m;
#ifdef SMOOTH
  float height = fine_height(heights, clamped);
#else
  float height = s.a;
#endif
#ifdef DETAIL
  vec2 q = detail_at(clamped);
  float share = detail_weight(q);
  s = mix(s, texture(detail_surface, q), share);
#ifdef SMOOTH
  height = mix(height, fine_height(detail_heights, q), share);
#else
  height = s.a;
#endif
#endif
  float change = max(length(s.xy) * pixel_m, 1e-4);
  float shade = s.b;
  // Water flattens the relief of its floor.
  bool flooded = water && height <= 0.0;
  float sea_near = 1.0;
#ifdef DRY
  sea_near = step(dry_at(clamped), 0.5);
  flooded = flooded && sea_near > 0.5;
#endif
  if (flooded) shade = mix(1.0, shade, 0.35 + 0.25 * exp(height / 40.0));
  // Models of dry land have 0 for the sea, whose depth is unknown.
  float unknown = sea_near * ramp(0.05, 0.0, abs(height)) * ramp(0.003, 0.0, abs(s.x) + abs(s.y));
  vec3 colour = tint(height - 60.0 * unknown, flooded || (water && unknown > 0.0));
  if (ground_style == 1) colour = vec3(0.585, 0.585, 0.58);
  if (ground_style == 2) colour = slope_colour(length(s.xy));
#ifdef OVERLAY
  vec4 over = overlay_at(clamped);
  colour = mix(colour, over.rgb, over.a);
#endif
  colour = shaded(colour, shade);
  colour = mix(colour, flooded ? vec3(0.04, 0.12, 0.20) : vec3(0.13, 0.08, 0.04), 0.5 * contours(height, change));
  if (water) {
    float coast = clamp01(1.3 - abs(height) / change);
    colour = mix(colour, vec3(0.03, 0.06, 0.10), 0.7 * coast * sea_near * (1.0 - unknown) * ramp(6.0, 1.0, texels));
  }
  vec2 out_px = max(max(-uv, uv - 1.0), 0.0) * vec2(textureSize(heights, 0)) / texels;
  float outside = clamp01(max(out_px.x, out_px.y));
  float shadow = 0.55 * exp(-max(0.0, max(out_px.x, out_px.y)) / 6.0);
  colour = mix(colour, paper * (1.0 - 0.4 * shadow), outside);
  result = shown(colour);
}

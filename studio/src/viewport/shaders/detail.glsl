// Finer ground within a window of the whole: its share at a place. As DetailGround.weight.
precision highp float;
precision highp sampler2D;
uniform vec4 detail_place;  // places of the ground (0 to 1) times zw plus xy are places of the window
uniform vec4 detail_fade, detail_edge;
uniform float detail_strength;  // 0: there is none
uniform sampler2D detail_heights;

vec2 detail_at(vec2 uv) { return uv * detail_place.zw + detail_place.xy; }

float detail_weight(vec2 q) {
  vec4 d = clamp(vec4(q, 1.0 - q) * detail_fade + detail_edge, 0.0, 1.0);
  float t = min(min(d.x, d.y), min(d.z, d.w));
  return detail_strength * t * t * (3.0 - 2.0 * t);
}

#ifdef DRY
uniform sampler2D dry, detail_dry;

// Share of dry ground: what lies below the sea there is no sea where it is above a half. As dryAt().
float dry_at(vec2 uv) {
  float share = textureLod(dry, uv, 0.0).r;
  vec2 q = detail_at(uv);
  return mix(share, textureLod(detail_dry, q, 0.0).r, detail_weight(q));
}
#endif

// Bilinear, at a place in cells; not left to the sampler, whose fractions are coarse.
float height_of(sampler2D heights, vec2 cells) {
  ivec2 last = textureSize(heights, 0) - 1;
  vec2 at = clamp(cells - 0.5, vec2(0.0), vec2(last));
  ivec2 a = ivec2(at), b = min(a + 1, last);
  vec2 t = at - vec2(a);
  return mix(mix(texelFetch(heights, a, 0).r, texelFetch(heights, ivec2(b.x, a.y), 0).r, t.x),
             mix(texelFetch(heights, ivec2(a.x, b.y), 0).r, texelFetch(heights, b, 0).r, t.x), t.y);
}

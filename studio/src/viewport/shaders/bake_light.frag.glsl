// Red: share of the sun that is seen; green: share of the sky. AROUND: coarser ground goes on around this one.
uniform sampler2D surface;
uniform float cell_m;
uniform float exaggeration;
uniform float floor_m;
uniform vec3 to_sun;
uniform vec2 light_size;
out vec4 result;

#ifdef AROUND
uniform sampler2D around;
uniform vec4 around_place;  // places of this ground times zw plus xy are places of that around
uniform float finer;        // levels
#endif

#ifdef DRY
uniform sampler2D dry, around_dry;
#endif

float raised(vec2 p, float level) {
  float height = textureLod(surface, p, level).a, water = floor_m;
#ifdef DRY
  if (textureLod(dry, p, level).r > 0.5) water = -1e9;
#endif
#ifdef AROUND
  if (p != clamp(p, 0.0, 1.0)) {
    vec2 q = p * around_place.zw + around_place.xy;
    height = textureLod(around, q, max(0.0, level - finer)).a;
#ifdef DRY
    water = textureLod(around_dry, q, max(0.0, level - finer)).r > 0.5 ? -1e9 : floor_m;
#endif
  }
#endif
  return exaggeration * max(water, height);
}

bool beyond(vec2 p) {
#ifdef AROUND
  p = p * around_place.zw + around_place.xy;
#endif
  return p != clamp(p, 0.0, 1.0);
}

void main() {
  vec2 size = vec2(textureSize(surface, 0)), p = gl_FragCoord.xy / light_size;
  vec2 texel = 1.0 / size;
  float scale = max(1.0, size.x / light_size.x);
  float start_level = log2(scale);
  float here = raised(p, start_level);
  float shift = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));

  vec2 sunward = normalize(vec2(to_sun.x, -to_sun.y));
  float sun_tangent = to_sun.z / max(1e-3, length(to_sun.xy));
  float blocked = -10.0, reach = 1.5 * scale;
  float farthest = 1.5 * max(size.x, size.y);
#ifdef AROUND
  farthest /= max(1e-3, max(around_place.z, around_place.w));
#endif
  for (int i = 0; i < 26; ++i) {
    vec2 q = p + sunward * reach * texel;
    if (beyond(q) || reach > farthest) break;
    float level = max(start_level, log2(0.13 * reach));
    blocked = max(blocked, (raised(q, level) - here) / (reach * cell_m));
    reach *= 1.24 + 0.03 * shift;
  }
  float soft = 0.05 + 0.05 * sun_tangent;
  float sun = 1.0 - ramp(sun_tangent - soft, sun_tangent + soft, blocked);

  float sky = 0.0;
  for (int i = 0; i < 6; ++i) {
    float angle = 1.047198 * (float(i) + shift);
    vec2 way = vec2(cos(angle), sin(angle));
    float horizon = 0.0, far = 1.5 * scale;
    for (int k = 0; k < 4; ++k) {
      vec2 q = p + way * far * texel;
      float rise = (raised(q, max(start_level, log2(0.3 * far))) - here) / (far * cell_m);
      horizon = max(horizon, rise);
      far *= 2.7;
    }
    sky += 1.0 - horizon * horizon / (1.0 + horizon * horizon) * 0.5 - 0.5 * horizon / sqrt(1.0 + horizon * horizon);
  }
  result = vec4(sun, sky / 6.0, 0.0, 1.0);
}

// A clear maritime sky: a gradient from zenith to horizon with a glow around the sun, and haze of its horizon's colour.
uniform vec3 to_sun;
uniform vec3 sun_light;
uniform vec3 sky_light;
uniform float sky_scale;
uniform float haze_density;
uniform float haze_far;

vec3 radiance(vec3 d) {
  float up = max(0.0, d.z), low = exp(-13.0 * up), middle = exp(-2.8 * up);
  float toward = max(0.0, dot(d, to_sun)), warm = toward * toward * toward;
  float dusk = ramp(0.30, 0.04, to_sun.z);
  vec3 horizon = mix(vec3(0.640, 0.740, 0.850), vec3(0.980, 0.620, 0.400), dusk * (0.35 + 0.65 * warm));
  vec3 colour = mix(vec3(0.105, 0.225, 0.500), mix(vec3(0.270, 0.440, 0.720), horizon, low), middle);
  float glow = (0.22 * warm + 0.25 * warm * warm * warm) * (0.25 + 0.75 * low);
  colour = mix(colour, mix(vec3(1.00, 0.82, 0.58), vec3(1.35, 0.62, 0.22), dusk), clamp01(glow * (1.0 + dusk)));
  return sky_scale * colour;
}

// On the horizon in a level direction.
vec3 horizon_light(vec2 d) {
  float toward = max(0.0, dot(d, to_sun.xy)), warm = toward * toward * toward;
  float dusk = ramp(0.30, 0.04, to_sun.z);
  vec3 horizon = mix(vec3(0.640, 0.740, 0.850), vec3(0.980, 0.620, 0.400), dusk * (0.35 + 0.65 * warm));
  float glow = 0.22 * warm + 0.25 * warm * warm * warm;
  return sky_scale * mix(horizon, mix(vec3(1.00, 0.82, 0.58), vec3(1.35, 0.62, 0.22), dusk), clamp01(glow * (1.0 + dusk)));
}

vec3 hazed(vec3 light, vec3 d, float far) {
  float depth = haze_density * far * (1.0 + far / haze_far);
  float through = exp(-0.5 * depth);
  vec3 share = through * vec3(sqrt(through), through, through * through);
  return light * share + (1.0 - share) * horizon_light(d.xy * inversesqrt(max(1e-6, dot(d.xy, d.xy))));
}

in vec3 place;
in float skirt;
uniform sampler2D surface, albedo, lights, noise, heights;
uniform vec3 eye;
uniform float cell_m, exaggeration, floor_m, border_depth, base_m;
uniform vec2 half_size;
uniform bool plane_only, in_sea;
uniform int ground_style;  // 0 natural, 1 one stone, 2 steepness
out vec4 result;

vec3 wave(vec2 p, float wavelength) {
  vec4 t = texture(noise, p / (8.0 * wavelength));
  return vec3(t.ba * 2.0 - 1.0, t.r - 0.5);
}

float fresnel_mean(float cosine) {
  return 0.02 + 0.98 * pow(1.0 - cosine, 3.1) / 2.7;
}

vec3 sea(vec2 uv, vec3 to_eye, float far) {
  float beyond = length(max(abs(place.xy) - half_size, 0.0)) / (2.0 * max(half_size.x, half_size.y));
  // The floor is seen where the refracted ray meets it.
  vec4 s = texture(surface, uv);
  float under = sqrt(1.0 - (1.0 - to_eye.z * to_eye.z) / 1.777);
  vec2 aside = -to_eye.xy / 1.333 / under * min(max(-s.a, 0.0), 30.0);
  vec2 q = uv + aside * vec2(1.0, -1.0) / (2.0 * half_size);
  float depth = max(0.0, -texture(surface, q).a);
  vec4 floor_texel = texture(albedo, q);
  vec3 floor_colour = floor_texel.rgb * floor_texel.rgb;
  vec4 light = texture(lights, uv);
  float outside = ramp(0.0, 0.12, beyond);
  depth = mix(depth, max(border_depth, 60.0), outside);
  float sun = mix(light.r, 1.0, outside), sky = mix(light.g, 1.0, outside);

  float shallow = ramp(0.0, 3.0, depth);
  vec3 swell = wave(mat2(0.8, 0.6, -0.6, 0.8) * place.xy, 230.0), chop = wave(place.xy, 31.0), ripple = wave(mat2(0.6, -0.8, 0.8, 0.6) * place.xy, 5.3);
  vec3 normal = normalize(vec3(-shallow * (0.09 * swell.xy + 0.16 * chop.xy + 0.14 * ripple.xy), 1.0));
  float cosine = max(0.02, dot(normal, to_eye));
  float sun_height = max(0.02, to_sun.z);
  vec3 down = sun * sun_height * 0.97 * sun_light + sky * sky_light;
  float path = depth * (1.0 / max(0.3, under) + 1.0 / sqrt(1.0 - (1.0 - sun_height * sun_height) / 1.777));
  vec3 deep = vec3(0.0024, 0.0185, 0.0500);
  vec3 body = deep + exp(-path * vec3(0.200, 0.0335, 0.0245)) * (0.80 * floor_colour - deep);
  float mirror = fresnel_mean(cosine);
  vec3 reflected = reflect(-to_eye, normal);
  reflected.z = max(0.06, reflected.z + 0.10);
  vec3 seen = (1.0 - mirror) * body * down + mirror * (0.4 + 0.6 * sky) * radiance(normalize(reflected));
  // The sun's road: facets that mirror it, by the slopes of a breeze.
  vec3 half_way = normalize(to_eye + to_sun);
  float tilt = max(0.2, dot(half_way, normal)), slope2 = (1.0 - tilt * tilt) / (tilt * tilt);
  float variance = 0.024 + 0.014 * swell.z;
  float glint = 0.0065 * exp(-slope2 / variance) / (variance * max(0.06, cosine) * tilt * tilt * tilt * tilt);
  seen += sun * (glint / (1.0 + 4.0 * glint)) * sun_light;
  // Foam: the wash on beaches and the surf on reefs.
  float breakers = clamp01(0.9 + 2.2 * chop.z + 1.6 * swell.z);
  float foam = clamp01(max(0.42 * ramp(1.3, 0.1, depth + 1.2 * chop.z), 0.95 * texture(albedo, uv).a) * breakers) * (1.0 - outside);
  return mix(seen, vec3(0.78, 0.80, 0.80) * down, 0.85 * foam);
}

vec3 stone_wall(vec3 to_eye) {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  float depth = place.z / exaggeration;
  vec3 earth = mix(vec3(0.150, 0.128, 0.106), vec3(0.205, 0.178, 0.148), 0.5 + 0.5 * sin(depth * 0.02 + 2.0 * wave(vec2(place.x + place.y, depth), 900.0).z));
  return earth * (max(0.0, dot(normal, to_sun)) * sun_light + 0.7 * sky_light);
}

vec3 land(vec2 uv, vec4 s, vec3 to_eye, float far) {
  vec4 ground = texture(albedo, uv);
  vec3 colour = ground.rgb * ground.rgb;
  // Grain that the cells are too coarse for, where the eye is near.
  float near = ramp(2.0, 0.6, length(fwidth(place.xy)) / cell_m * 2.5);
  vec3 grain = wave(mat2(0.8, 0.6, -0.6, 0.8) * place.xy, 0.35 * cell_m) + 0.6 * wave(place.xy, 0.06 * cell_m);
  colour *= 1.0 + near * 0.9 * grain.z;
  float slope = length(s.xy);
  vec2 gradient = s.xy * exaggeration - near * (0.10 + 0.25 * min(slope, 1.0)) * grain.xy;
  vec3 normal = normalize(vec3(-gradient, 1.0));
  if (ground_style == 1) colour = vec3(0.42, 0.41, 0.39);
  if (ground_style == 2) colour = slope_colour(slope) * 0.55;
  vec4 over = overlay_at(uv);
  colour = mix(colour, over.rgb * 0.62, over.a);
  vec4 light = texture(lights, uv);
  float facing = max(0.0, dot(normal, to_sun)) * light.r;
  float open = light.g * (0.55 + 0.45 * normal.z);
  vec3 sky = open * (0.85 + 0.15 * dot(normal, to_sun)) * sky_light;
  float bounce = 0.35 * (1.0 - open) * (0.3 + 0.7 * to_sun.z);
  vec3 seen = colour * (facing * sun_light + sky + bounce * colour * sun_light);
  return seen * (1.0 + 0.12 * max(0.0, dot(to_eye, to_sun)));
}

void main() {
  vec2 uv = vec2(0.5 + 0.5 * place.x / half_size.x, 0.5 - 0.5 * place.y / half_size.y);
  vec3 to_eye = eye - place;
  float far = length(to_eye);
  to_eye /= far;
  vec4 s = texture(surface, uv);
  float change = max(fwidth(s.a), 1e-4);
  vec3 light;
  if (skirt > 0.001) {
    light = stone_wall(to_eye);
  } else {
    float wet = plane_only ? 1.0 : floor_m < -1e8 ? 0.0 : clamp01(0.5 - s.a / change);
    light = vec3(0.0);
    if (wet < 1.0) light += (1.0 - wet) * land(uv, s, to_eye, far);
    if (wet > 0.0) {
      vec3 water = sea(uv, to_eye, far);
      vec4 over = overlay_at(uv);
      if (over.a > 0.0) water = mix(water, over.rgb * 0.62 * (to_sun.z * sun_light + sky_light), over.a * 0.85);
      light += wet * water;
    }
    if (contour_m > 0.0 && !plane_only) light = mix(light, contour_colour, contours(s.a, change) * 0.8);
  }
  result = shown(tone_curve(hazed(light, -to_eye, far)));
}

in vec3 place;
in float skirt;
uniform sampler2D surface, lit, noise, heights;
uniform vec3 eye;
uniform float cell_m, exaggeration, floor_m, border_depth, base_m, pixel_angle, sun_path;
uniform vec2 half_size;
uniform bool plane_only, in_sea;
out vec4 result;

// Where cells are larger than pixels: a smooth surface through them (cubic B-spline by four taps), without their grid.
vec4 smooth_at(sampler2D t, vec2 uv, bool magnified) {
  if (!magnified) return texture(t, uv);
  vec2 size = vec2(textureSize(t, 0)), at = uv * size - 0.5, whole = floor(at), f = at - whole;
  vec2 g = 1.0 - f, w0 = g * g * g / 6.0, w1 = (4.0 - 6.0 * f * f + 3.0 * f * f * f) / 6.0;
  vec2 w3 = f * f * f / 6.0, w2 = 1.0 - w0 - w1 - w3;
  vec2 low = w0 + w1, high = w2 + w3;
  vec2 a = (whole - 0.5 + w1 / low) / size, b = (whole + 1.5 + w3 / high) / size;
  return low.y * (low.x * textureLod(t, a, 0.0) + high.x * textureLod(t, vec2(b.x, a.y), 0.0)) +
         high.y * (low.x * textureLod(t, vec2(a.x, b.y), 0.0) + high.x * textureLod(t, b, 0.0));
}

vec3 wave(vec2 p, float wavelength) {
  vec4 t = texture(noise, p / (8.0 * wavelength));
  return vec3(t.ba * 2.0 - 1.0, t.r - 0.5);
}

// `s`: of the ground below; `beyond`: how far outside the terrain, in its sizes.
vec3 sea(vec2 uv, vec4 s, vec3 to_eye, float far, float beyond, bool magnified) {
  float outside = ramp(0.0, 0.12, beyond);
  float under = sqrt(1.0 - (1.0 - to_eye.z * to_eye.z) / 1.777);
  float depth = max(0.0, -s.a);
  vec3 level = max(0.02, to_sun.z) * 0.97 * sun_light + sky_light;
  vec3 deep = vec3(0.0024, 0.0185, 0.0500);
  vec3 body = deep * level;
  float surf = 0.0, wash_depth = depth;
  if (outside < 1.0 && depth < 120.0) {
    // The floor is seen where the refracted ray meets it.
    vec2 aside = -to_eye.xy / (1.333 * under) * min(depth, 30.0);
    vec2 q = uv + aside * vec2(0.5, -0.5) / half_size;
    depth = max(0.0, -smooth_at(surface, q, magnified).a);
    vec4 ground = smooth_at(lit, q, magnified);
    vec3 floor_light = 1.6 * ground.rgb * ground.rgb * level;
    float path = depth * (1.0 / max(0.3, under) + sun_path) + 300.0 * outside;
    body += exp(-path * vec3(0.200, 0.0335, 0.0245)) * (floor_light - body);
    surf = ground.a * (1.0 - outside) * ramp(5.0, 0.8, wash_depth);
  } else {
    depth = max(depth, 60.0);
  }
  // Long waves and short ones tilt the surface; what is too small to see is in the statistics.
  float shallow = ramp(0.0, 3.0, depth);
  vec3 swell = wave(mat2(0.8, 0.6, -0.6, 0.8) * place.xy, 330.0);
  vec2 tilt = 0.045 * swell.xy;
  float breakers = swell.z;
  if (far < 700.0 * 31.0) {
    vec3 chop = wave(mat2(0.28, 0.96, -0.96, 0.28) * place.xy, 31.0);
    tilt += 0.11 * chop.xy;
    breakers += 1.4 * chop.z;
  }
  if (far < 500.0 * 5.3) tilt += 0.10 * wave(mat2(0.6, -0.8, 0.8, 0.6) * place.xy, 5.3).xy;
  vec3 normal = normalize(vec3(-shallow * tilt, 1.0));
  float cosine = max(0.02, dot(normal, to_eye));
  float grazing = 1.0 - cosine;
  float mirror = 0.02 + 0.36 * grazing * grazing * grazing;
  vec3 reflected = reflect(-to_eye, normal);
  reflected.z = max(0.06, reflected.z + 0.10);
  vec3 seen = mix(body, radiance(normalize(reflected)), mirror);
  // The sun's road: facets that mirror it, by the slopes of a breeze.
  vec3 half_way = normalize(to_eye + to_sun);
  float facing = max(0.2, dot(half_way, normal)), slope2 = 1.0 / (facing * facing) - 1.0;
  float variance = 0.010 + 0.008 * swell.z;
  if (slope2 < 6.0 * variance) {
    float glint = 0.00075 * exp(-slope2 / variance) / (variance * max(0.08, cosine));
    seen += shallow * glint / (1.0 + 3.0 * glint) * sun_light;
  }
  // Foam: the wash on beaches and the surf on reefs.
  float wash = outside > 0.0 ? 0.0 : (0.14 + 0.3 * surf) * ramp(1.3, 0.1, wash_depth + 1.2 * breakers);
  float foam = max(wash, 0.9 * surf * clamp01(0.75 + 2.2 * breakers));
  return foam > 0.0 ? mix(seen, vec3(0.80) * level, 0.85 * foam * clamp01(0.9 + 1.6 * breakers)) : seen;
}

vec3 stone_wall(vec3 to_eye) {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  vec2 along = vec2(abs(normal.x) > 0.5 ? place.y : place.x, place.z);
  float beds = wave(along * vec2(0.12, 1.0), 0.006 * half_size.x).z + 0.5 * wave(along * vec2(0.3, 2.0), 0.003 * half_size.x).z;
  vec3 earth = vec3(0.150, 0.130, 0.110) * (1.0 + 0.55 * beds);
  return earth * (0.6 * max(0.0, dot(normal, to_sun)) * sun_light + 0.8 * sky_light + 0.08 * sun_light);
}

vec3 land(vec2 uv, vec4 s, vec3 to_eye, float far, bool magnified) {
  vec4 ground = smooth_at(lit, uv, magnified);
  vec3 level = to_sun.z * sun_light + sky_light;
  vec3 seen = 2.0 * ground.rgb * ground.rgb;
  // Grain that the cells are too coarse for, where the eye is near: crowns and stones, more on slopes.
  float near = ramp(1.8, 0.6, far * pixel_angle * 2.5 / cell_m);
  if (near > 0.0) {
    float size = min(cell_m, 90.0);
    vec3 grain = wave(mat2(0.8, 0.6, -0.6, 0.8) * place.xy, 0.55 * size) + 0.7 * wave(mat2(0.28, 0.96, -0.96, 0.28) * place.xy, 0.13 * size);
    if (far * pixel_angle < 0.02 * size) grain += 0.6 * wave(place.xy, 0.025 * size);
    float steep = min(1.0, length(s.xy));
    seen *= max(0.25, 1.0 + near * ((0.75 + 0.5 * steep) * grain.z + (0.30 + 0.35 * steep) * dot(grain.xy, normalize(to_sun.xy + 1e-4))));
  }
  if (overlay_strength > 0.0) {
    // The light stays, the colour is the overlay's.
    vec4 over = overlay_at(uv);
    seen = mix(seen, over.rgb * clamp(0.25 + 2.2 * luminance(seen) / (luminance(seen) + 0.35), 0.25, 1.6) * 0.5, over.a);
  }
  return seen * level * (1.0 + 0.12 * max(0.0, dot(to_eye, to_sun)));
}

void main() {
  vec2 uv = vec2(0.5 + 0.5 * place.x / half_size.x, 0.5 - 0.5 * place.y / half_size.y);
  vec3 to_eye = eye - place;
  float far = length(to_eye);
  to_eye /= far;
  vec3 light = vec3(0.0);
  if (skirt > 0.001) {
    light = stone_wall(to_eye);
  } else {
    vec2 out_m = max(abs(place.xy) - half_size, 0.0);
    float beyond = plane_only ? length(out_m) / (2.0 * max(half_size.x, half_size.y)) : 0.0;
    bool magnified = far * pixel_angle * 2.2 < cell_m;
    vec4 s = beyond < 0.12 ? smooth_at(surface, uv, magnified) : vec4(0.0, 0.0, 1.0, -1000.0);
    float change = max(fwidth(s.a), 1e-4);
    float wet = plane_only ? 1.0 : floor_m < -1e8 ? 0.0 : clamp01(0.5 - s.a / change);
    if (wet < 1.0) light = (1.0 - wet) * land(uv, s, to_eye, far, magnified);
    if (wet > 0.0) {
      vec3 water = sea(uv, s, to_eye, far, beyond, magnified);
      if (overlay_strength > 0.0) {
        vec4 over = overlay_at(uv);
        water = mix(water, over.rgb * 0.5 * (to_sun.z * sun_light + sky_light), over.a * 0.85);
      }
      light += wet * water;
    }
    if (contour_m > 0.0 && !plane_only) light = mix(light, contour_colour, contours(s.a, change) * 0.8);
  }
  result = shown(tone_curve(hazed(light, -to_eye, far)));
}

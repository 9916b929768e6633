// Ground in its light, view-independent: reflectance times light over that of level open ground, as the square root of
// half of it. Under water: the floor's. Alpha: how open to swell.
uniform sampler2D surface, albedo, lights;
#ifdef DRY
uniform sampler2D dry;
#endif
uniform float exaggeration, floor_m;
uniform vec3 to_sun, sun_light, sky_light;
uniform int ground_style;  // 0 natural, 1 one stone, 2 steepness
out vec4 result;

void main() {
  vec2 p = gl_FragCoord.xy / vec2(textureSize(surface, 0));
  vec4 s = textureLod(surface, p, 0.0), ground = texture(albedo, p);
  vec2 light = textureLod(lights, p, 0.0).rg;
  vec3 colour = ground.rgb * ground.rgb;
  float slope = length(s.xy);
  if (ground_style == 1) colour = vec3(0.42, 0.41, 0.39);
  if (ground_style == 2) colour = slope_colour(slope) * 0.55;
  vec3 level = to_sun.z * sun_light + sky_light;
  bool flooded = s.a < floor_m;
#ifdef DRY
  flooded = flooded && texture(dry, p).r <= 0.5;
#endif
  vec2 gradient = flooded ? vec2(0.25 * s.xy) : s.xy * exaggeration;
  vec3 normal = normalize(vec3(-gradient, 1.0));
  float facing = max(0.0, dot(normal, to_sun)) * light.r;
  float open = light.g * (0.55 + 0.45 * normal.z);
  vec3 sky = open * (0.85 + 0.15 * dot(normal, to_sun)) * sky_light;
  float bounce = 0.35 * (1.0 - open) * (0.3 + 0.7 * to_sun.z);
  vec3 seen = colour * (facing * sun_light + sky + bounce * colour * sun_light) / level;
  float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  result = vec4(sqrt(clamp(0.5 * seen, 0.0, 1.0)) + grain / 255.0, ground.a);
}

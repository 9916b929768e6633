// Natural colours of the ground, as square roots of reflectances; alpha: how open to swell it is. After the C++
// renderer's ground (src/seamount/ops/render), in a climate.
uniform sampler2D surface;
uniform sampler2D noise;
uniform float cell_m;
uniform float scale;  // cells of this picture a cell of the heights
uniform float coarse_m, finer;  // cells of the whole ground, and how many levels coarser those are than these
uniform vec2 middle;  // of this ground beside that of the whole, metres east and south
#ifdef DRY
uniform sampler2D dry;  // 1: no sea, however low
#endif
uniform float warmth_c, rain_mm, latitude, low_m;  // mean of the year at the sea, rain over the land, lowest ground
uniform vec2 rain_from;  // bearing of the wind that brings it, as a vector
uniform bool basalt;
uniform float snow_line, tree_line;
out vec4 result;

const vec3 kSand = vec3(0.560, 0.475, 0.345), kWetSand = vec3(0.330, 0.270, 0.185), kColdSand = vec3(0.270, 0.245, 0.190);
const vec3 kLagoonSand = vec3(0.600, 0.560, 0.450), kReefFlat = vec3(0.430, 0.370, 0.255), kCoral = vec3(0.165, 0.120, 0.070);
const vec3 kForeReef = vec3(0.105, 0.098, 0.070), kDeepFloor = vec3(0.170, 0.165, 0.150), kWeed = vec3(0.052, 0.054, 0.026);
const vec3 kSeagrass = vec3(0.075, 0.088, 0.042), kDesertSand = vec3(0.420, 0.300, 0.170);

struct Breakup { float broad, medium, fine; };

float noise_at(vec2 p, float wavelength) { return (texture(noise, p / (8.0 * wavelength)).r - 0.5) * 1.7; }

vec3 rock_dark() { return basalt ? vec3(0.040, 0.035, 0.032) : vec3(0.062, 0.057, 0.052); }
vec3 scree() { return basalt ? vec3(0.092, 0.080, 0.070) : vec3(0.150, 0.138, 0.121); }

vec3 rock(vec4 s, float slope, Breakup n) {
  vec3 pale = basalt ? vec3(0.110, 0.092, 0.078) : vec3(0.215, 0.200, 0.178);
  float bedding = 0.45 * ramp(0.25, 0.7, slope) * sin((s.a + 30.0 * n.medium + 90.0 * n.broad) * 6.2832 / 95.0) * 0.5;
  float shade = clamp01(0.45 + bedding + 0.8 * n.medium + 0.5 * n.fine + 0.25 * n.broad - 1.1 * clamp(s.b, -0.2, 0.2) - 0.14 * (slope - 1.0));
  vec3 stained = mix(pale, pale * vec3(1.0, 0.88, 0.74), ramp(0.0, 0.4, n.broad + n.medium));
  return mix(rock_dark(), stained, shade);
}

// How the plants of a place do, as growth_of() of the C++ renderer (land_cover.cpp): mean warmth of the year; log2 of
// rain over what plants could use, 0 is just enough for forest; 1 above the tree line.
struct Growth { float warmth, water, cold; };

Growth growth(vec2 p, vec4 s, float deep, float slope, float shade, Breakup n) {
  float z = max(s.a, 0.0);
  float warmth = warmth_c - 0.0030 * low_m - 0.0065 * (z - low_m);
  // Rain falls on the side that the wind comes from.
  float rise = -dot(textureLod(surface, p, 5.0 + finer).xy, rain_from);
  float enough = log2(rain_mm / (58.93 * clamp(warmth, 4.0, 30.0)));
  float water = enough + 2.2 * clamp(rise, -0.5, 0.35) + 1.6 * clamp(s.b, -0.2, 0.2) + 2.6 * clamp(deep, -0.2, 0.2)
      + 0.7 * min(1.0, abs(latitude) / 35.0) * shade - 0.35 * min(slope, 1.5)
      + 0.55 * n.medium + 0.45 * n.broad + 0.25 * n.fine;
  float cold = ramp(-1.0, 1.0, (s.a - tree_line) / 260.0 + 1.1 * n.medium + 0.7 * n.broad);
  return Growth(warmth, water, cold);
}

// Ground without plants.
vec3 bare(vec4 s, float slope, Growth g, Breakup n) {
  vec3 soil = mix(vec3(0.115, 0.076, 0.046), vec3(0.150, 0.080, 0.044), ramp(17.0, 24.0, g.warmth) * clamp01(0.6 + n.broad));
  vec3 gravel = mix(scree(), rock_dark(), clamp01(0.25 + 0.8 * n.fine));
  vec3 desert = mix(mix(kDesertSand, scree(), 0.45), gravel, clamp01(0.30 + 0.7 * n.medium + 1.2 * slope));
  float stony = max(g.cold, ramp(0.30, 0.60, slope + 0.2 * n.medium));
  return mix(mix(soil, gravel, stony), desert, ramp(-1.3, -2.6, g.water));
}

vec3 herbs(Growth g, Breakup n) {
  vec3 dry_grass = mix(vec3(0.155, 0.127, 0.074), vec3(0.172, 0.145, 0.073), clamp01(0.5 + 0.8 * n.medium));
  vec3 grass = mix(dry_grass, vec3(0.098, 0.102, 0.050), ramp(-1.4, 0.35, g.water));
  vec3 heath = mix(vec3(0.115, 0.102, 0.050), vec3(0.052, 0.058, 0.028), ramp(0.0, 0.7, n.fine + 0.5 * n.medium + 0.2));
  return mix(grass, heath, clamp01(0.75 * g.cold + ramp(5.0, -1.0, g.warmth)));
}

vec3 crowns(float hollow, Growth g, Breakup n) {
  float light = clamp01(0.42 + 0.45 * n.medium + 0.6 * n.fine - 0.9 * hollow);
  vec3 needle = mix(vec3(0.017, 0.027, 0.015), vec3(0.033, 0.043, 0.022), light);
  vec3 leaf = mix(vec3(0.034, 0.046, 0.018), vec3(0.066, 0.076, 0.031), light);
  vec3 rain_forest = mix(vec3(0.023, 0.035, 0.015), vec3(0.052, 0.064, 0.030), light);
  vec3 trees = mix(needle, leaf, ramp(3.0, 11.0, g.warmth + 5.0 * n.medium));
  return mix(trees, rain_forest, ramp(15.0, 22.0, g.warmth) * ramp(-0.3, 0.5, g.water));
}

// `shore`: height over a sea that is near.
vec3 land(vec2 p, vec4 s, float shore, float deep, float slope, Breakup n) {
  float z = s.a, hollow = clamp(s.b, -0.2, 0.2);
  float shade = clamp(latitude < 0.0 ? s.y : -s.y, -0.8, 0.8);  // of slopes away from the noon's sun
  Growth g = growth(p, s, deep, slope, shade, n);
  float uneven = slope + 0.30 * n.medium + 0.26 * n.fine - 0.5 * hollow;
  // Roots hold steeper ground where it is warm and wet.
  float grip = 0.55 * ramp(0.0, 1.2, g.water) * ramp(14.0, 22.0, g.warmth);
  float forest = ramp(-0.75, 0.35, g.water) * (1.0 - ramp(0.72, 1.08, uneven - grip)) * (1.0 - g.cold) * ramp(1.0, 6.0, shore + 2.5 * n.medium);
  float alpine = (z - 0.5 * (tree_line + snow_line)) / 700.0 + 0.8 * n.medium + 0.5 * n.fine + uneven;
  float herb = ramp(-2.5, -0.6, g.water + 0.9 * n.fine) * (1.0 - ramp(0.88, 1.30, uneven - grip)) * ramp(-9.0, -1.0, g.warmth + 6.0 * n.medium) * (1.0 - ramp(0.15, 0.85, alpine));
  float rocky = ramp(0.72, 1.05, uneven - 0.5 * grip);

  vec3 ground = mix(bare(s, slope, g, n), rock(s, slope, n), rocky);
  ground = mix(ground, herbs(g, n), herb);
  // Shrubs where it is too dry for forest, as a tint.
  ground = mix(ground, vec3(0.052, 0.058, 0.028), 0.22 * ramp(-2.2, -0.4, g.water) * (1.0 - g.cold) * (1.0 - rocky));
  ground = mix(ground, crowns(hollow, g, n), forest);

  float over = z - snow_line + 130.0 * n.medium + 120.0 * n.broad + 700.0 * hollow + 260.0 * shade;
  float snow = ramp(-160.0, 240.0, over) * (1.0 - ramp(0.95, 1.40, slope + 0.30 * n.medium + 0.22 * n.fine));
  ground = mix(ground, mix(vec3(0.830, 0.855, 0.890), vec3(0.560, 0.600, 0.640), 0.6 * ramp(300.0, -100.0, over)), snow);

  float built = ramp(5.0, 2.4, shore + 1.5 * n.medium) * ramp(0.20, 0.07, slope) * ramp(-0.30, 0.05, n.broad + 0.3 * n.medium + 1.5 * hollow);
  vec3 sand = mix(mix(kColdSand, kSand, ramp(8.0, 19.0, warmth_c)), vec3(0.080, 0.074, 0.070), basalt ? 0.12 : 0.0);
  ground = mix(ground, mix(sand, mix(kWetSand, 0.6 * sand, 0.5), ramp(0.8, 0.1, shore)), built);
  float spray = ramp(9.0, 2.0, shore + 4.0 * n.medium) * ramp(0.15, 0.5, slope) * (1.0 - built);
  ground = mix(ground, rock_dark(), 0.8 * spray);
  return (1.0 + 0.22 * n.fine * (1.0 - 0.7 * snow)) * ground;
}

vec3 sea_floor(vec4 s, float slope, Breakup n) {
  float depth = -s.a;
  float warm = ramp(15.5, 19.5, warmth_c);  // where reefs grow
  float sheltered = clamp01(4.0 * s.b);
  float gentle = ramp(0.32, 0.10, slope * (1.0 - 0.75 * sheltered) + 0.06 * n.medium);
  float reef = warm * ramp(7.0, 3.0, depth) * clamp01(0.35 - 2.5 * s.b);
  float lagoon = gentle * ramp(90.0, 40.0, depth);
  vec3 floor_colour = mix(kForeReef, kDeepFloor, ramp(60.0, 300.0, depth));
  float patches = ramp(0.18, 0.50, n.medium + 0.5 * n.fine + 0.45 * n.broad + 0.12) * ramp(0.8, 3.5, depth + 1.5 * n.medium);
  vec3 bed = mix(mix(kColdSand, kLagoonSand, warm), mix(kWeed, kCoral, warm), 0.70 * patches);
  floor_colour = mix(floor_colour, bed, max(lagoon, gentle * ramp(34.0, 12.0, depth + 8.0 * n.medium)));
  float fields = ramp(-0.25, 0.15, n.medium + 0.5 * n.broad + 0.35 * n.fine) * ramp(4.5, 2.0, depth) * ramp(0.5, 1.6, depth) * warm;
  vec3 rubble = mix(kReefFlat, mix(kCoral, kSeagrass, 0.5), clamp01(0.45 + 0.8 * n.fine + 0.6 * n.medium));
  floor_colour = mix(floor_colour, rubble, 0.6 * fields * (1.0 - reef));
  float growth = ramp(0.05, 0.50, n.medium + 0.6 * n.fine + 0.12);
  floor_colour = mix(floor_colour, mix(kForeReef, mix(kReefFlat, kCoral, 0.7 * growth), ramp(7.0, 2.0, depth + 1.5 * n.medium)), reef);
  float wash = ramp(2.2, 0.4, depth + 0.8 * n.medium) * gentle;
  floor_colour = mix(floor_colour, mix(kColdSand, kSand, warm), wash * (1.0 - 0.7 * reef));
  return (1.0 + 0.20 * n.fine) * floor_colour;
}

// How open the water is close by: swell breaks where a shallow floor drops into it.
float openness(vec2 p) {
  float reach = max(60.0, 1.8 * coarse_m), sum = 0.0;
  vec2 metre = 1.0 / (vec2(textureSize(surface, 0)) * cell_m);
  for (int i = 0; i < 5; ++i) {
    float angle = 1.256637 * float(i) + 0.39;
    sum += ramp(6.0, 30.0, -textureLod(surface, p + reach * metre * vec2(cos(angle), sin(angle)), 1.0 + finer).a);
  }
  return ramp(0.3, 1.5, sum);
}

// Positive in hollows: how much lower than its surroundings, over their size.
float concavity(vec2 p, float height, float level) {
  return clamp((textureLod(surface, p, level).a - height) / (exp2(level) * cell_m), -8.0, 8.0);
}

void main() {
  vec2 size = vec2(textureSize(surface, 0)), p = gl_FragCoord.xy / (scale * size);
  vec4 s = textureLod(surface, p, 0.0);
  s.b = 1.6 * concavity(p, s.a, 2.0 + finer);
  vec2 place = (gl_FragCoord.xy / scale - 0.5 * size) * cell_m + middle;
  Breakup n = Breakup(noise_at(mat2(0.92, 0.39, -0.39, 0.92) * place, 2400.0), noise_at(mat2(0.6, 0.8, -0.8, 0.6) * place, max(170.0, 3.2 * coarse_m)), noise_at(mat2(0.28, 0.96, -0.96, 0.28) * place, max(18.0, 2.1 * cell_m)));
  float slope = length(s.xy), deep = 1.6 * concavity(p, s.a, 4.0 + finer);
  float shore = s.a, up = clamp01((s.a + 0.3) / 0.6);
#ifdef DRY
  // Around hollows there are no beaches.
  shore = mix(shore, 1000.0, ramp(0.0, 0.04, textureLod(dry, p, 4.0 + finer).r));
  up = max(up, ramp(0.4, 0.6, textureLod(dry, p, 0.0).r));
#endif
  vec3 colour = mix(sea_floor(s, slope, n), land(p, s, shore, deep, slope, n), up);
  result = vec4(sqrt(clamp(colour, 0.0, 1.0)), openness(p));
}

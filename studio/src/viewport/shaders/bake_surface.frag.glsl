// Of each cell: gradient (east, north; metres a metre), relief shading for the map, height. Four lights, the main one
// from the north-west, on the ground as it is and on a smoother one.
uniform sampler2D heights;
uniform float cell_m, relief_scale;
uniform int broad;  // cells to the corners of the smoother ground
uniform vec2 result_size;
out vec4 result;

float at(ivec2 p) { return texelFetch(heights, clamp(p, ivec2(0), textureSize(heights, 0) - 1), 0).r; }

float lambert(vec2 gradient) {
  const vec3 a = vec3(-0.5417, 0.5417, 0.6428), b = vec3(0.0494, 0.7644, 0.6428), c = vec3(-0.7644, -0.0494, 0.6428), d = vec3(0.7435, -0.1841, 0.6428);
  vec3 n = inversesqrt(1.0 + dot(gradient, gradient)) * vec3(-gradient, 1.0);
  return (0.55 * max(0.0, dot(n, a)) + 0.18 * max(0.0, dot(n, b)) + 0.18 * max(0.0, dot(n, c)) + 0.09 * max(0.0, dot(n, d))) / 0.6428;
}

void main() {
  // Where the result is coarser than the heights, so are the steps.
  vec2 coarser = vec2(textureSize(heights, 0)) / result_size;
  int k = max(1, int(coarser.x + 0.5));
  float step_m = float(k) * cell_m;
  ivec2 p = ivec2(gl_FragCoord.xy * coarser);
  float h = at(p);
  float e = at(p + k * ivec2(1, 0)), w = at(p - k * ivec2(1, 0)), s = at(p + k * ivec2(0, 1)), n = at(p - k * ivec2(0, 1));
  float ne = at(p + k * ivec2(1, -1)), se = at(p + k * ivec2(1, 1)), nw = at(p + k * ivec2(-1, -1)), sw = at(p + k * ivec2(-1, 1));
  float east = (2.0 * (e - w) + (ne - nw) + (se - sw)) / (8.0 * step_m);
  float north = (2.0 * (n - s) + (ne - se) + (nw - sw)) / (8.0 * step_m);
  float ba = at(p + broad * ivec2(1, -1)), bb = at(p + broad), bc = at(p - broad), bd = at(p + broad * ivec2(-1, 1)), broad_m = float(broad) * cell_m;
  vec2 broad = vec2(ba + bb - bc - bd, ba + bc - bb - bd) / (4.0 * broad_m);
  float direct = 0.66 * lambert(relief_scale * vec2(east, north)) + 0.34 * lambert(1.4 * relief_scale * broad);
  float soft = direct < 1.0 ? 1.0 - 0.80 * (1.0 - direct) : 1.0 + 1.5 * (direct - 1.0);
  // Hollows are a little darker, ridges lighter: less and more of the sky is seen from there.
  float shade = soft * (1.0 - clamp(0.5 * relief_scale * (0.25 * (ba + bb + bc + bd) - h) / (1.4 * broad_m), -0.10, 0.30));
  result = vec4(clamp(vec2(east, north), -60.0, 60.0), shade, clamp(h, -6e4, 6e4));
}

// Of each cell: gradient (east, north; metres a metre), concavity (positive in hollows), height.
uniform sampler2D heights;
uniform float cell_m;
out vec4 result;

float at(ivec2 p) { return texelFetch(heights, clamp(p, ivec2(0), textureSize(heights, 0) - 1), 0).r; }

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  float h = at(p);
  float e = at(p + ivec2(1, 0)), w = at(p - ivec2(1, 0)), s = at(p + ivec2(0, 1)), n = at(p - ivec2(0, 1));
  float ne = at(p + ivec2(1, -1)), se = at(p + ivec2(1, 1)), nw = at(p + ivec2(-1, -1)), sw = at(p + ivec2(-1, 1));
  float east = (2.0 * (e - w) + (ne - nw) + (se - sw)) / (8.0 * cell_m);
  float north = (2.0 * (n - s) + (ne - se) + (nw - sw)) / (8.0 * cell_m);
  float ring = at(p + ivec2(4, 0)) + at(p - ivec2(4, 0)) + at(p + ivec2(0, 4)) + at(p - ivec2(0, 4)) +
               at(p + ivec2(3, 3)) + at(p - ivec2(3, 3)) + at(p + ivec2(-3, 3)) + at(p + ivec2(3, -3));
  result = vec4(clamp(vec2(east, north), -60.0, 60.0), clamp((ring / 8.0 - h) / (4.0 * cell_m), -8.0, 8.0), clamp(h, -6e4, 6e4));
}

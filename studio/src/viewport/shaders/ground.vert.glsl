// A patch of ground: a grid that samples the height field, morphed towards its parent's grid with distance; at the
// domain's edge a skirt hangs down.
in vec3 position;
in vec3 patch_box;
in vec2 patch_morph;
uniform mat4 viewMatrix, projectionMatrix;
uniform sampler2D heights;
uniform float cell_m, exaggeration, floor_m, base_m;
uniform vec3 eye;
out vec3 place;
out float skirt;

// Of both grids in one way for all patches, so that neighbours meet wherever the window of the finer one ends.
float height_at(vec2 d) {
  float height = height_of(heights, d);
  vec2 q = detail_at(d / vec2(textureSize(heights, 0)));
  float share = detail_weight(q);
  if (share > 0.0) height = mix(height, height_of(detail_heights, q * vec2(textureSize(detail_heights, 0))), share);
  return height;
}

vec3 placed(vec2 d) {
  vec2 cells = vec2(textureSize(heights, 0)), half_size = 0.5 * cell_m * cells;
  float height = height_at(d), water = floor_m;
#ifdef DRY
  if (dry_at(d / cells) > 0.5) water = -1e9;
#endif
  return vec3(d.x * cell_m - half_size.x, half_size.y - d.y * cell_m, exaggeration * max(water, height));
}

void main() {
  vec2 cells = vec2(textureSize(heights, 0)), grid = position.xy;
  float stride = patch_box.z / 16.0;
  vec2 d = min(patch_box.xy + grid * stride, cells);
  place = placed(d);
  float k = clamp((distance(place, eye) - patch_morph.x) / (patch_morph.y - patch_morph.x), 0.0, 1.0);
  if (k > 0.0) {
    d = min(patch_box.xy + (grid - k * mod(grid, 2.0)) * stride, cells);
    place = placed(d);
  }
  skirt = 0.0;
  if (position.z > 0.0 && (any(lessThanEqual(d, vec2(0.0))) || any(greaterThanEqual(d, cells)))) {
    place.z = base_m;
    skirt = 1.0;
  }
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}

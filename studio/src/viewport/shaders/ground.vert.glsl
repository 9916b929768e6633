// A patch of ground: a grid that samples the height field, morphed towards its parent's grid with distance; at the
// domain's edge a skirt hangs down.
precision highp float;
precision highp sampler2D;
in vec3 position;
in vec3 patch_box;
in vec2 patch_morph;
uniform mat4 viewMatrix, projectionMatrix;
uniform sampler2D heights;
uniform float cell_m, exaggeration, floor_m, base_m;
uniform vec3 eye;
out vec3 place;
out float skirt;

float height_at(vec2 d) {
  ivec2 last = textureSize(heights, 0) - 1;
  vec2 at = clamp(d - 0.5, vec2(0.0), vec2(last));
  ivec2 a = ivec2(at), b = min(a + 1, last);
  vec2 t = at - vec2(a);
  return mix(mix(texelFetch(heights, a, 0).r, texelFetch(heights, ivec2(b.x, a.y), 0).r, t.x),
             mix(texelFetch(heights, ivec2(a.x, b.y), 0).r, texelFetch(heights, b, 0).r, t.x), t.y);
}

vec3 placed(vec2 d) {
  vec2 half_size = 0.5 * cell_m * vec2(textureSize(heights, 0));
  return vec3(d.x * cell_m - half_size.x, half_size.y - d.y * cell_m, exaggeration * max(floor_m, height_at(d)));
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

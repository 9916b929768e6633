// A thing on the ground. One under water is moved along the line of sight to just before the surface, where the water
// does not hide it; its colour is that of what is seen through so much water.
precision highp float;
in vec3 position, normal, colour;
in vec4 thing;  // place beside the picture's origin, scale
in float angle;
uniform mat4 viewMatrix, projectionMatrix;
uniform sampler2D dry;
uniform vec2 half_size;
uniform vec3 eye, origin_shift;
uniform float exaggeration, floor_m;
out vec3 place, facing, tint;
out float depth;

void main() {
  float c = cos(angle), s = sin(angle);
  mat3 turn = mat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);
  place = vec3(thing.xy, thing.z * exaggeration) + origin_shift + turn * (position * thing.w);
  facing = turn * normal;
  tint = colour * (colour * (colour * 0.305306011 + 0.682171111) + 0.012522878);  // from the display's curve
  vec2 at = thing.xy + origin_shift.xy;
  float low_land = textureLod(dry, vec2(0.5 + 0.5 * at.x / half_size.x, 0.5 - 0.5 * at.y / half_size.y), 0.0).r;
  depth = floor_m < -1e8 || low_land > 0.5 ? 0.0 : max(0.0, -place.z);
  vec3 seen = place;
  if (depth > 0.0 && eye.z > 0.0) {
    float t = eye.z / (eye.z - place.z);
    seen = eye + (place - eye) * t * (0.9985 + 0.0010 * (1.0 - exp(-0.05 * depth)));
  }
  gl_Position = projectionMatrix * viewMatrix * vec4(seen, 1.0);
}

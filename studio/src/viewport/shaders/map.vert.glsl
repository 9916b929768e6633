precision highp float;
in vec3 position;
uniform vec4 map_place;  // places of the ground (0 to 1) at the picture's middle, and half its size
out vec2 uv;
void main() {
  uv = map_place.xy + position.xy * map_place.zw;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}

precision highp float;
in vec3 position;
uniform vec3 forward, right, upward;
out vec3 ray;
void main() {
  ray = forward + position.x * right + position.y * upward;
  gl_Position = vec4(position.xy, 0.99999, 1.0);
}

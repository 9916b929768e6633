// The sea's plane, far beyond the terrain.
precision highp float;
in vec3 position;
uniform mat4 viewMatrix, projectionMatrix;
uniform vec2 sea_size;
out vec3 place;
out float skirt;
void main() {
  place = vec3(position.xy * sea_size, 0.0);
  skirt = 0.0;
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}

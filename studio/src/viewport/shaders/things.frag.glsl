in vec3 place, facing, tint;
in float depth;
uniform vec3 eye;
uniform float sun_path;
out vec4 result;

void main() {
  vec3 to_eye = eye - place;
  float far = length(to_eye);
  to_eye /= far;
  vec3 normal = normalize(facing);
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  // Leaves let some light through.
  float sun = max(0.0, dot(normal, to_sun)) + 0.18 * max(0.0, -dot(normal, to_sun));
  vec3 light = tint * (sun * sun_light + (0.62 + 0.38 * normal.z) * sky_light);
  vec3 level = max(0.02, to_sun.z) * sun_light + sky_light;
  float path = depth * (1.0 / max(0.3, sqrt(1.0 - (1.0 - to_eye.z * to_eye.z) / 1.777)) + sun_path);
  vec3 deep = vec3(0.0024, 0.0185, 0.0500) * level;
  light = mix(light, deep + exp(-path * vec3(0.200, 0.0335, 0.0245)) * (0.8 * light - deep), step(1e-4, depth));
  result = shown(tone_curve(hazed(light, -to_eye, far)));
}

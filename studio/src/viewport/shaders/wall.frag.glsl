// The cut through the ground at the domain's edge.
in vec3 place;
in float skirt;
uniform sampler2D noise;
uniform vec3 eye;
uniform vec2 half_size;
out vec4 result;

vec3 wave(vec2 p, float wavelength) {
  vec4 t = texture(noise, p / (8.0 * wavelength));
  return vec3(t.ba * 2.0 - 1.0, t.r - 0.5);
}

vec3 stone_wall(vec3 to_eye) {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  vec2 along = vec2(abs(normal.x) > 0.5 ? place.y : place.x, place.z);
  float beds = wave(along * vec2(0.12, 1.0), 0.006 * half_size.x).z + 0.5 * wave(along * vec2(0.3, 2.0), 0.003 * half_size.x).z;
  vec3 earth = vec3(0.205, 0.175, 0.145) * (1.0 + 0.45 * beds) * (1.0 - 0.55 * skirt);
  return earth * (0.6 * max(0.0, dot(normal, to_sun)) * sun_light + 0.8 * sky_light + 0.08 * sun_light);
}

void main() {
  vec3 to_eye = eye - place;
  float far = length(to_eye);
  result = shown(tone_curve(hazed(stone_wall(to_eye / far), -to_eye / far, far)));
}

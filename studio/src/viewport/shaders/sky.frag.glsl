in vec3 ray;
uniform bool in_sea;
out vec4 result;
void main() {
  vec3 d = normalize(ray);
  vec3 light = radiance(d);
  // Without a sea the ground stands before a pale backdrop.
  if (!in_sea) light = mix(light, sky_scale * vec3(0.46, 0.49, 0.52), ramp(0.02, -0.35, d.z) * 0.9);
  result = shown(tone_curve(light));
}

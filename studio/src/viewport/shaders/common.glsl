precision highp float;
precision highp int;
precision highp sampler2D;

float ramp(float low, float high, float x) {
  float t = clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
float clamp01(float x) { return clamp(x, 0.0, 1.0); }
float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// Film-like: a toe, slope near 1, a shoulder that keeps the hue of bright colours.
vec3 film(vec3 x) { return clamp(x * (2.43 * x + 0.10) / (x * (2.30 * x + 0.86) + 0.16), 0.0, 1.0); }
vec3 tone_curve(vec3 scene) {
  float light = max(luminance(scene), 1e-6);
  return mix(film(scene), clamp(scene * (film(vec3(light)).r / light), 0.0, 1.0), 0.45);
}
// The display's curve to half a step, by roots only: they are cheap where the processor draws.
vec3 srgb(vec3 c) {
  vec3 a = sqrt(c), b = sqrt(a), d = sqrt(b);
  return mix(12.92 * c, 0.662002687 * a + 0.684122060 * b - 0.323583601 * d - 0.0225411470 * c, step(0.0031308, c));
}
vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
// Less than one step of the display against bands in skies and seas.
float dither() { return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }
vec4 shown(vec3 display) { return vec4(srgb(display) + dither(), 1.0); }

// The paper and the paint on it: the mirror of render/picture/paper.cpp.
#include "noise.glsl"

float paper_grain(ivec2 pixel) {
  float x = float(pixel.x), y = float(pixel.y);
  float tooth = gradient_noise(vec3(x / 1.9, y / 1.9, 0.5), 201u);
  float fleck = gradient_noise(vec3((x + y) / 9.0, (x - y) / 3.7, 0.5), 202u);
  return 0.9 * tooth + 0.7 * fleck;
}

float paper_age(ivec2 pixel, vec2 size) {
  vec2 u = 2.0 * (vec2(pixel) + 0.5) / size - 1.0;
  vec2 u4 = u * u * u * u;
  float side = min(size.x, size.y);
  float cloud = gradient_noise(vec3(3.1 * vec2(pixel) / side, 0.5), 203u);
  return 1.0 - (1.0 - u4.x) * (1.0 - u4.y) + 0.35 * cloud;
}

uniform vec3 paper;
uniform float grain;
uniform float vignette;
uniform vec3 paint;  // saturation, lightness, granulation times grain

// `grain_here` is paper_grain(), if the style has grain.
vec3 paper_color(ivec2 pixel, vec2 size, float grain_here) {
  if (grain == 0.0 && vignette == 0.0) return paper;
  vec3 lab = to_oklab(paper);
  lab.x += grain * grain_here;
  if (vignette > 0.0) lab += vignette * paper_age(pixel, size) * vec3(-1.0, 0.08, 0.22);
  return clamp(from_oklab(lab), 0.0, 1.0);
}

vec3 painted(vec3 color, float grain_here) {
  if (paint == vec3(1.0, 0.0, 0.0)) return color;
  vec3 lab = to_oklab(max(color, 0.0));
  lab.x += paint.y + paint.z * grain_here;
  lab.yz *= paint.x;
  return clamp(from_oklab(lab), 0.0, 1.0);
}

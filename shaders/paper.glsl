// The paper's grain: the mirror of render/picture/paper.cpp.
#include "noise.glsl"

float paper_grain(ivec2 pixel) {
  float x = float(pixel.x), y = float(pixel.y);
  float tooth = gradient_noise(vec3(x / 1.9, y / 1.9, 0.5), 201u);
  float fleck = gradient_noise(vec3((x + y) / 9.0, (x - y) / 3.7, 0.5), 202u);
  return 0.9 * tooth + 0.7 * fleck;
}

// The contribution of one transparent layer to a picture.
#include "gbuffer.glsl"
#include "lit.glsl"

uniform vec3 eye;  // scene
uniform bool inked;

const float least_cosine = 0.06;  // limits the thickness of a film seen edge-on

// From 1 on the contour, where the surface turns away from the eye, to 0 at a line's width beside it. `slope` is the
// change of the cosine from sample to sample.
float contour(float cosine, float slope, float width) {
  float samples_away = abs(cosine) / max(slope, 1e-5);
  return 1.0 - smoothstep(0.3 * width, width, samples_away);
}

// Colour times coverage, and coverage.
vec4 film(vec3 color, vec3 normal, vec3 to_eye, float slope, uint instance) {
  vec3 n = dot(normal, to_eye) < 0.0 ? -normal : normal;
  float cosine = dot(n, to_eye);

  // The longer the path of the light through a film, the more of it is absorbed.
  float through = -log(1.0 - pen_of(instance).w) / max(cosine, least_cosine);
  float coverage = 1.0 - exp(-through);
  vec3 lit = dull_color(color, n, vec2(1.0), false);
  if (inked) {
    float line = contour(cosine, slope, 2.0 * pen_of(instance).y);
    lit = mix(lit, ink_of(instance).rgb, 0.85 * line);
    coverage = mix(coverage, 1.0, 0.7 * line);
  }
  vec3 spot = 0.2 * gloss * vec3(shine(n, to_eye, false));
  return vec4(clamp(lit, 0.0, 1.0) * coverage + spot, coverage);
}

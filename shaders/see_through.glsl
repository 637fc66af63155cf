// See-through solids leave out some of a pixel's samples; each solid leaves out others.
#include "gbuffer.glsl"

uniform float opacity;

bool left_out(uint instance) {
  if (opacity >= 1.0) return false;
  return fract(interleaved(gl_FragCoord.xy) + 0.618034 * float(instance)) >= opacity;
}

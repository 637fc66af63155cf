// Only depth, seen from the light. Transparent solids omit some of their samples, different ones for each instance, so
// that they cast a partial shadow.
#include "gbuffer.glsl"

uniform uint instance_id;
uniform float opacity;

void main() {
#ifdef SEE_THROUGH
  float share = fract(interleaved(gl_FragCoord.xy) + 0.618034 * float(instance_of(instance_id)));
  if (share >= opacity) discard;
#endif
}

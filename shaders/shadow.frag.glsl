// Depth alone, as the light sees it. What is see-through leaves out some of its samples, each instance others, so that
// it casts a part of a shadow.
#include "gbuffer.glsl"

uniform uint instance_id;
uniform float opacity;

void main() {
#ifdef SEE_THROUGH
  float share = fract(interleaved(gl_FragCoord.xy) + 0.618034 * float(instance_of(instance_id)));
  if (share >= opacity) discard;
#endif
}

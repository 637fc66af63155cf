// See-through solids leave out some of a pixel's samples; each solid leaves out others. Opaque ones are drawn by
// programs without SEE_THROUGH: where a shader can discard, hidden samples cannot be passed over early.
#include "gbuffer.glsl"

uniform uint instance_id;  // with the see-through bit

#ifdef SEE_THROUGH
uniform float opacity;

bool left_out() {
  // Both sides of an inner surface have triangles of their own in one place: only the near side is drawn.
  if (!gl_FrontFacing) return true;
  float share = fract(interleaved(gl_FragCoord.xy) + 0.618034 * float(instance_of(instance_id)));
  return share >= opacity;
}
#endif

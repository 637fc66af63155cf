// Depth alone, as the light sees it.
#include "see_through.glsl"

void main() {
#ifdef SEE_THROUGH
  if (left_out()) discard;
#endif
}

// Depth alone, as the light sees it.
#include "see_through.glsl"

uniform uint instance_id;

void main() {
  if (left_out(instance_of(instance_id))) discard;
}

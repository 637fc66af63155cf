// The inputs of later passes: the plain colour and the material, normal, id, and the shares of texture detail if a scene
// has any. It does little, because most of what is drawn here is hidden again, or too small to fill a block of pixels.
#include "gbuffer.glsl"

uniform uint instance_id;
uniform int first_triangle;  // of the solid, in triangle_tags
uniform usamplerBuffer triangle_tags;

in vec3 scene_normal;
in vec3 plain_color;
flat in float material_number;
in float rim;

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal_line;
layout(location = 2) out uint id;

#ifdef DETAILED
in vec4 share;
layout(location = 3) out vec4 guide_share;
#endif

void main() {
  vec3 n = normalize(scene_normal);
  albedo = vec4(plain_color, material_number);
  normal_line = vec4(gl_FrontFacing ? n : -n, rim);
  id = instance_id | texelFetch(triangle_tags, first_triangle + gl_PrimitiveID).r;
#ifdef DETAILED
  guide_share = share;
#endif
}

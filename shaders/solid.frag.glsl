// What the later passes want to know: modulated colour, normal, id.
#include "noise.glsl"
#include "see_through.glsl"

uniform uint instance_id;        // with the see-through bit
uniform int first_triangle;      // of the solid, in triangle_tags
uniform float footprint_scale;   // samples a pixel's side
uniform usamplerBuffer triangle_tags;

in vec3 fruit_position;
in vec3 scene_normal;
in vec3 plain_color;

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal_line;
layout(location = 2) out uint id;

void main() {
  float footprint = footprint_scale * max(length(dFdx(fruit_position)), length(dFdy(fruit_position)));
  if (left_out(instance_of(instance_id))) discard;
  vec3 n = normalize(scene_normal);
  albedo = vec4(modulated(plain_color, fruit_position, footprint), 1.0);
  normal_line = vec4(gl_FrontFacing ? n : -n, 0.0);
  id = instance_id | texelFetch(triangle_tags, first_triangle + gl_PrimitiveID).r;
}

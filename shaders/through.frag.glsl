// How much of the sunlight reaches a place through the fruit, and how much would leave the fruit behind it: by the path
// of the light from the nearest surface towards the light, and to the farthest one away from it [Green 2004].
#include "gbuffer.glsl"
#include "material.glsl"

uniform sampler2D albedo;
uniform sampler2D depth;
uniform sampler2D normal_line;
uniform sampler2D shadow_map;
uniform sampler2D far_map;  // the same, of the farthest surface from the light
uniform int samples_per_side;
uniform vec2 tangent;
uniform mat4 view;
uniform mat4 camera_to_light;
uniform vec2 light_box;  // metres: side and depth of the shadow map's box
uniform float slack;     // metres; the error of the map

layout(location = 0) out vec4 arrives;
layout(location = 1) out vec4 leaves;

vec3 kept(float metres, Material m) { return exp(-metres / (m.depth * max(m.inner_color, 0.02))); }

void main() {
  arrives = leaves = vec4(0.0);
  ivec2 at = ivec2(gl_FragCoord.xy) * samples_per_side + samples_per_side / 2;
  float far = texelFetch(depth, at, 0).r;
  if (far == 1.0) return;
  Material m = material_at(texelFetch(albedo, at, 0).a);
  if (m.depth <= 0.0) return;
  float distance_to = distance_from_depth(far);
  vec2 size = vec2(textureSize(depth, 0));
  vec3 p = vec3((2.0 * (vec2(at) + 0.5) / size - 1.0) * tangent, -1.0) * distance_to;
  vec3 n = mat3(view) * texelFetch(normal_line, at, 0).xyz;

  // From just inside, averaged over the distance that the light travels, because it also comes from the sides.
  vec3 q = (camera_to_light * vec4(p - n * slack, 1.0)).xyz;
  vec2 direction = first_direction(gl_FragCoord.xy);
  float reach = 0.7 * m.depth / light_box.x;
  const int count = 8;
  int i = 0;
  do {
    vec2 there = q.xy + reach * spiral_radius(i, count) * direction;
    direction = golden_angle * direction;
    float before = (q.z - texture(shadow_map, there).r) * light_box.y - slack;
    float behind = (texture(far_map, there).r - q.z) * light_box.y - slack;
    arrives.rgb += kept(max(before, 0.0), m) / float(count);
    leaves.rgb += kept(max(behind, 0.0), m) / float(count);
  } while (++i < count);
}

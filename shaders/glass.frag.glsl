// The nearest transparent surface behind the last layer. It does little, because most of what is drawn here is hidden
// again.
#ifdef ALL_THAT_IS_LEFT
#include "glass_film.glsl"
#endif

uniform uint instance_id;
uniform sampler2D last_depth;

in vec4 normal_cosine;
in vec3 plain_color;

#ifdef ALL_THAT_IS_LEFT
in vec3 scene_point;

// Sums over all remaining surfaces, in any order.
layout(location = 0) out vec4 layer;
layout(location = 1) out vec4 thickness;
#else
layout(location = 0) out vec4 color_slope;
layout(location = 1) out vec4 normal;
layout(location = 2) out uint id;
#endif

void main() {
  float slope = fwidth(normal_cosine.w);
  if (gl_FragCoord.z <= texelFetch(last_depth, ivec2(gl_FragCoord.xy), 0).r) discard;
#ifdef ALL_THAT_IS_LEFT
  layer = film(plain_color, normalize(normal_cosine.xyz), normalize(eye - scene_point), slope, instance_of(instance_id));
  thickness = vec4(-log(max(1.0 - layer.a, 1e-4)));
#else
  color_slope = vec4(plain_color, slope);
  normal = vec4(normal_cosine.xyz, 1.0);
  id = instance_id;
#endif
}

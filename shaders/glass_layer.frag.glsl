// One lit layer, or everything after the last layer: colour times coverage, and coverage.
#ifdef ALL_THAT_IS_LEFT
uniform sampler2D layer;
uniform sampler2D thickness;
#else
#include "glass_film.glsl"

uniform sampler2D color_slope;
uniform sampler2D normal;
uniform usampler2D ids;
uniform sampler2D depth;
uniform vec2 tangent;  // of half the field of view
uniform mat4 camera_to_scene;
#endif

layout(location = 0) out vec4 color;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
#ifdef ALL_THAT_IS_LEFT
  // Sums: the mean colour by coverage, with the joint coverage of all.
  vec4 sum = texelFetch(layer, at, 0);
  float together = 1.0 - exp(-texelFetch(thickness, at, 0).r);
  color = sum.a > 0.0 ? vec4(sum.rgb / sum.a, 1.0) * together : vec4(0.0);
#else
  uint id = texelFetch(ids, at, 0).r;
  if (id == 0u) discard;
  vec2 ndc = 2.0 * gl_FragCoord.xy / vec2(textureSize(ids, 0)) - 1.0;
  vec3 to_eye = normalize(mat3(camera_to_scene) * vec3(-ndc * tangent, 1.0));
  vec4 plain = texelFetch(color_slope, at, 0);
  color = film(plain.rgb, normalize(texelFetch(normal, at, 0).xyz), to_eye, plain.a, instance_of(id));
#endif
}

// Hairs, as lines a sample wide.
#include "gbuffer.glsl"
#include "lit.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 along;   // the hair's direction here
layout(location = 2) in vec3 color;
layout(location = 3) in vec4 normal;  // of the skin at its root; 0 at the root to 1 at the tip

uniform mat4 placement;
uniform mat4 projection;
uniform mat4 view;
uniform vec3 eye;
uniform float sample_angle;  // size of a sample at distance 1
uniform sampler2D light;     // sky, sun, distance

out vec4 hair;  // colour times coverage, coverage

const float hair_width = 0.00011;  // metres: twice that of real hair, so that fuzz is visible in small pictures

void main() {
  vec4 scene_point = placement * vec4(position, 1.0);
  vec3 n = normalize(mat3(placement) * normal.xyz), t = normalize(mat3(placement) * along);
  vec3 to_eye = normalize(eye - scene_point.xyz);
  gl_Position = projection * scene_point;
  gl_Position.z -= 1e-5 * gl_Position.w;

  // The light at its root is that of the skin.
  vec2 ndc = gl_Position.xy / gl_Position.w;
  vec2 seen = textureLod(light, 0.5 + 0.5 * ndc, 0.0).xy;
  float across = sqrt(max(1.0 - dot(t, to_light) * dot(t, to_light), 0.0));
  float facing = wrapped(dot(n, to_light) + 0.25);
  float direct = mix(0.25, 1.0, seen.y) * facing * mix(0.5, 1.15, across);
  vec3 received = sky_at(n.y, seen.x) + light_strengths.x * sun * direct;

  float away = -(view * scene_point).z;
  float coverage = clamp(hair_width / (sample_angle * away), 0.05, 1.0) * (1.0 - 0.75 * normal.w * normal.w);
  hair = vec4(clamp(color * received * mix(0.62, 1.25, normal.w), 0.0, 1.0), 1.0) * coverage;
}

// A vertex of a transparent solid, with the cosine of its viewing angle.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;

uniform mat4 placement;   // fruit to scene
uniform mat4 projection;  // scene to clip space
uniform vec3 eye;         // scene

out vec4 normal_cosine;
out vec3 plain_color;
#ifdef ALL_THAT_IS_LEFT
out vec3 scene_point;
#endif

void main() {
  vec3 at = (placement * vec4(position, 1.0)).xyz;
  vec3 n = mat3(placement) * normal;
  normal_cosine = vec4(n, dot(n, normalize(eye - at)));
  plain_color = color;
#ifdef ALL_THAT_IS_LEFT
  scene_point = at;
#endif
  gl_Position = projection * vec4(at, 1.0);
}

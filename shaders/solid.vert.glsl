// A solid's vertices, placed.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
layout(location = 3) in float material;
layout(location = 4) in vec4 relief;  // addition of the parts' relief to the normal of a cut face; metres to the part's rim

#ifdef DETAILED
layout(location = 5) in vec4 guide_share;  // of each detail
out vec4 share;
#endif

uniform mat4 placement;  // fruit to scene
uniform mat4 projection; // scene to clip space

out vec3 scene_normal;
out vec3 plain_color;
flat out float material_number;
out float rim;

invariant gl_Position;

void main() {
  scene_normal = mat3(placement) * (normal + relief.xyz);
  rim = 1000.0 * relief.w;
  plain_color = color;
  material_number = material;
#ifdef DETAILED
  share = guide_share;
#endif
  gl_Position = projection * (placement * vec4(position, 1.0));
}

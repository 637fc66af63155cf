// Lines on cut faces where the colour jumps.
layout(location = 0) in vec3 position;
layout(location = 1) in float strength;

uniform mat4 placement;
uniform mat4 projection;

out float line_strength;

void main() {
  line_strength = strength;
  gl_Position = projection * (placement * vec4(position, 1.0));
  gl_Position.z -= 2e-4 * gl_Position.w;  // in front of the face it lies on
}

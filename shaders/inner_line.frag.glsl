// Only the fourth channel beside the normal is written.
in float line_strength;

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal_line;
layout(location = 2) out uint id;

void main() {
  albedo = vec4(0.0);
  normal_line = vec4(0.0, 0.0, 0.0, line_strength);
  id = 0u;
}

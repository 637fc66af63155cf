layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal_line;
layout(location = 2) out uint id;
#ifdef DETAILED
layout(location = 3) out vec4 guide_share;
#endif

void main() {
  albedo = vec4(1.0);  // the last pass adds the paper's colour with its grain
  normal_line = vec4(0.0, 1.0, 0.0, 0.0);
  id = 0u;
#ifdef DETAILED
  guide_share = vec4(0.0);
#endif
}

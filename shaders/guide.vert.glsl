// A solid's vertices, placed exactly as solid.vert.glsl places them, with what guides their details.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 guide_way;    // to the skin, metres; depth of the layer
layout(location = 2) in vec4 guide_share;  // of each detail

uniform mat4 placement;
uniform mat4 projection;

out vec4 way_layer;
out vec4 share;

invariant gl_Position;

void main() {
  way_layer = guide_way;
  share = guide_share;
  gl_Position = projection * (placement * vec4(position, 1.0));
}

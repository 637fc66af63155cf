// The table: a large square at height 0.
uniform mat4 projection;
uniform vec3 ground_center;
uniform float ground_reach;

void main() {
  vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
  gl_Position = projection * vec4(ground_center.x + ground_reach * corner.x, 0.0,
                                  ground_center.z - ground_reach * corner.y, 1.0);
}

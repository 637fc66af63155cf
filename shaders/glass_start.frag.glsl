// Where a layer may lie: in front of opaque surfaces, and nowhere if nothing behind would be visible.
uniform sampler2D opaque_depth;
uniform sampler2D gathered;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  gl_FragDepth = texelFetch(gathered, at, 0).a > 0.996 ? 0.0 : texelFetch(opaque_depth, at, 0).r;
}

// Smooths sky and light along one direction, but not across edges of depth.
uniform sampler2D light_in;
uniform vec2 direction;

layout(location = 0) out vec4 light;

void main() {
  ivec2 size = textureSize(light_in, 0);
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(light_in, at, 0);
  vec2 sum = here.xy;
  float total = 1.0;
  for (int i = -4; i <= 4; ++i) {
    if (i == 0) continue;
    ivec2 there = clamp(at + i * ivec2(direction), ivec2(0), size - 1);
    vec4 other = texelFetch(light_in, there, 0);
    float weight = exp(-0.09 * float(i * i)) * max(0.0, 1.0 - 40.0 * abs(other.z - here.z) / here.z);
    sum += weight * other.xy;
    total += weight;
  }
  light = vec4(sum / total, here.zw);
}

// Positive mean values, last pass: which points may lie on a surface. Only these are computed again in double
// precision.
layout(local_size_x = 64) in;

// More than 1e-5 of the surfaces' size, which is less than 2 here, and more than the error of single precision.
const float near = 2.1e-5;
const int most_depth = 32;
const int no_more = -2147483647 - 1;

layout(std430, binding = 0) readonly restrict buffer Nodes { uvec4 node[]; };          // as in pmvc_rays
layout(std430, binding = 1) readonly restrict buffer Triangles { uvec4 triangle[]; };  // likewise
layout(std430, binding = 2) restrict buffer Seen { vec4 seen[]; };                     // as in pmvc_sums
layout(std430, binding = 4) readonly restrict buffer Points { vec4 point[]; };
layout(std430, binding = 5) readonly restrict buffer Groups { uvec4 group[]; };

bool holds(vec3 low, vec3 high, vec3 p) {
  return all(greaterThanEqual(p, low - near)) && all(lessThanEqual(p, high + near));
}

// In the triangle's box, and near its plane. The last term exceeds the rounding of the normal.
bool is_near(uint first, vec3 p) {
  vec3 a = uintBitsToFloat(triangle[first].xyz);
  vec3 b = uintBitsToFloat(triangle[first + 1u].xyz);
  vec3 c = uintBitsToFloat(triangle[first + 2u].xyz);
  if (!holds(min(a, min(b, c)), max(a, max(b, c)), p)) return false;
  vec3 normal = cross(b - a, c - a);
  float reach = length(b - a) + length(c - a);
  return abs(dot(normal, p - a)) <= near * length(normal) + 1e-6 * reach * (reach + near);
}

bool any_near(uint nodes, uint triangles, vec3 p) {
  int waiting[most_depth];
  waiting[0] = no_more;
  int top = 0, at = 0;
  while (at != no_more) {
    if (at >= 0) {
      uint first = 4u * (nodes + at);
      uvec4 low0 = node[first], high0 = node[first + 1u], low1 = node[first + 2u], high1 = node[first + 3u];
      if (holds(uintBitsToFloat(low0.xyz), uintBitsToFloat(high0.xyz), p)) waiting[++top] = int(low0.w);
      if (holds(uintBitsToFloat(low1.xyz), uintBitsToFloat(high1.xyz), p)) waiting[++top] = int(low1.w);
    } else {
      // A leaf: 28 bits of the first triangle, 3 bits of their number.
      int first = ~at >> 3, end = first + (~at & 7);
      for (int index = first; index < end; ++index) {
        if (is_near(3u * (triangles + index), p)) return true;
      }
    }
    at = waiting[top--];
  }
  return false;
}

void main() {
  uvec4 sizes = group[2u * gl_WorkGroupID.x], begins = group[2u * gl_WorkGroupID.x + 1u];
  uint lane = gl_LocalInvocationID.x;
  if (lane >= sizes.x) return;
  uint mine = 64u * gl_WorkGroupID.x + lane;
  if (any_near(begins.x, begins.y, point[mine].xyz)) seen[2u * mine + 1u].z = 1.0;
}

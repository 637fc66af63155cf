// Positive mean values, first pass: what points see along a block of lines, ahead and behind. One work-group is 64
// neighbouring points of one fruit that cast along the same lines at the same time, so that they traverse the same
// boxes. Each invocation sums its own block in a fixed order; nothing is shared.
layout(local_size_x = 64) in;

const uint lines_per_block = 8u;
const int most_depth = 32;

// All lengths are normalised: each fruit fits into [-1, 1].
layout(std430, binding = 0) readonly restrict buffer Nodes { uvec4 node[]; };          // 4 each, see ray_surfaces.h
layout(std430, binding = 1) readonly restrict buffer Triangles { uvec4 triangle[]; };  // 3 corners: x, y, z, vertex
layout(std430, binding = 2) readonly restrict buffer Sides { uvec2 side[]; };          // number; parts, 16 bits each
layout(std430, binding = 3) readonly restrict buffer Colors { vec4 color[]; };         // front, back of each vertex
layout(std430, binding = 4) readonly restrict buffer Points { vec4 point[]; };         // 64 for each group
layout(std430, binding = 5) readonly restrict buffer Groups { uvec4 group[]; };        // 2 each, see gl_pmvc.cpp
layout(std430, binding = 6) readonly restrict buffer Lines { vec4 line[]; };           // across_u, across_v, along
layout(std430, binding = 7) restrict buffer Sums { float sum[]; };

uniform uint first_line;   // of this chunk
uniform uint line_count;   // in all chunks
uniform uint first_block;  // of this dispatch, within the chunk

const int no_more = -2147483647 - 1;  // marks the bottom of the stack
const float far = 3.0e38;

struct Hit {
  float distance;  // > 0
  int triangle;    // < 0: none
  bool front;
  float second, third;  // barycentric coordinates
};

struct Look {
  vec3 eye, across_u, across_v, along, inverse;
  uint nodes, triangles;  // where this fruit begins
};

// The same bits for a corner in all of its triangles, so that no line passes between two triangles.
float component(vec3 q, vec3 axis) {
  precise float sum = fma(q.x, axis.x, fma(q.y, axis.y, q.z * axis.z));
  return sum;
}

// Exactly the negative of edge(q, p).
float edge(vec2 p, vec2 q) {
  precise float area = p.x * q.y - p.y * q.x;
  return area;
}

vec3 seen_along(Look look, uvec4 corner) {
  vec3 q = uintBitsToFloat(corner.xyz) - look.eye;
  return vec3(component(q, look.across_u), component(q, look.across_v), component(q, look.along));
}

// Of equal distances the triangle with the smaller index wins.
bool is_nearer(Look look, float distance, int index, Hit hit) {
  if (distance != hit.distance) return distance < hit.distance;
  return hit.triangle >= 0 && side[look.triangles + index].x < side[look.triangles + hit.triangle].x;
}

void try_triangle(Look look, int index, inout Hit ahead, inout Hit behind) {
  uint first = 3u * (look.triangles + index);
  vec3 a = seen_along(look, triangle[first]);
  vec3 b = seen_along(look, triangle[first + 1u]);
  vec3 c = seen_along(look, triangle[first + 2u]);

  // Inside or on an edge if no two edge functions differ in sign.
  vec3 areas = vec3(edge(b.xy, c.xy), edge(c.xy, a.xy), edge(a.xy, b.xy));
  float least = min(areas.x, min(areas.y, areas.z)), most = max(areas.x, max(areas.y, areas.z));
  if (least < 0.0 && most > 0.0) return;
  float area = areas.x + areas.y + areas.z;
  if (area == 0.0) return;
  areas /= area;

  // With a negative area the front faces against the line, so a ray along the line sees it.
  float distance = dot(areas, vec3(a.z, b.z, c.z));
  if (distance > 0.0 && is_nearer(look, distance, index, ahead)) {
    ahead = Hit(distance, index, area < 0.0, areas.y, areas.z);
  } else if (distance < 0.0 && is_nearer(look, -distance, index, behind)) {
    behind = Hit(-distance, index, area > 0.0, areas.y, areas.z);
  }
}

// The places where the line enters and leaves a box.
vec2 crossing(Look look, vec3 low, vec3 high) {
  vec3 one = (low - look.eye) * look.inverse, other = (high - look.eye) * look.inverse;
  vec3 enter = min(one, other), leave = max(one, other);
  return vec2(max(enter.x, max(enter.y, enter.z)), min(leave.x, min(leave.y, leave.z)));
}

bool is_worth(vec2 box, Hit ahead, Hit behind) {
  return box.x <= box.y && box.x <= ahead.distance && -box.y <= behind.distance;
}

// The nearest triangle ahead and the nearest behind.
void see(Look look, out Hit ahead, out Hit behind) {
  ahead = behind = Hit(far, -1, false, 0.0, 0.0);
  int waiting[most_depth];
  waiting[0] = no_more;
  int top = 0, at = 0;
  while (true) {
    // Descend into the boxes, the nearer one first.
    while (at >= 0) {
      uint first = 4u * (look.nodes + at);
      uvec4 low0 = node[first], high0 = node[first + 1u], low1 = node[first + 2u], high1 = node[first + 3u];
      vec2 box0 = crossing(look, uintBitsToFloat(low0.xyz), uintBitsToFloat(high0.xyz));
      vec2 box1 = crossing(look, uintBitsToFloat(low1.xyz), uintBitsToFloat(high1.xyz));
      bool worth0 = is_worth(box0, ahead, behind), worth1 = is_worth(box1, ahead, behind);
      bool swapped = max(box1.x, -box1.y) < max(box0.x, -box0.y);
      int child0 = int(low0.w), child1 = int(low1.w);
      if (worth0 && worth1) {
        waiting[++top] = swapped ? child0 : child1;
        at = swapped ? child1 : child0;
      } else if (worth0 || worth1) {
        at = worth0 ? child0 : child1;
      } else {
        at = waiting[top--];
      }
    }
    if (at == no_more) return;

    // A leaf: 28 bits of the first triangle, 3 bits of their number.
    int first = ~at >> 3, end = first + (~at & 7);
    for (int index = first; index < end; ++index) try_triangle(look, index, ahead, behind);
    at = waiting[top--];
  }
}

// Adds colour / distance and 1 / distance.
void add(Hit hit, Look look, uint colors, uint slot, inout vec4 total) {
  if (hit.triangle < 0) return;
  uint at = look.triangles + hit.triangle, back = hit.front ? 0u : 1u;
  vec3 mixed = (1.0 - hit.second - hit.third) * color[2u * (colors + triangle[3u * at].w) + back].rgb +
               hit.second * color[2u * (colors + triangle[3u * at + 1u].w) + back].rgb +
               hit.third * color[2u * (colors + triangle[3u * at + 2u].w) + back].rgb;
  float weight = 1.0 / hit.distance;
  total += vec4(mixed * weight, weight);
  uint part = hit.front ? side[at].y & 0xffffu : side[at].y >> 16;
  sum[slot + 64u * (4u + part)] += weight;
}

void main() {
  uvec4 sizes = group[2u * gl_WorkGroupID.x], begins = group[2u * gl_WorkGroupID.x + 1u];
  uint lane = gl_LocalInvocationID.x;
  if (lane >= sizes.x) return;

  // This block's sums: colour and weight, then the weight of each part.
  uint block = first_block + gl_WorkGroupID.y, parts = sizes.y;
  uint slot = sizes.z + 64u * (4u + parts) * block + lane;
  for (uint part = 0u; part < parts; ++part) sum[slot + 64u * (4u + part)] = 0.0;
  vec4 total = vec4(0.0);

  Look look;
  look.eye = point[64u * gl_WorkGroupID.x + lane].xyz;
  look.nodes = begins.x;
  look.triangles = begins.y;
  uint first = first_line + lines_per_block * block, end = min(first + lines_per_block, line_count);
  for (uint i = first; i < end; ++i) {
    look.across_u = line[3u * i].xyz;
    look.across_v = line[3u * i + 1u].xyz;
    look.along = line[3u * i + 2u].xyz;
    look.inverse = 1.0 / mix(look.along, vec3(1e-20), lessThan(abs(look.along), vec3(1e-20)));
    Hit ahead, behind;
    see(look, ahead, behind);
    add(ahead, look, begins.z, slot, total);
    add(behind, look, begins.z, slot, total);
  }
  for (uint k = 0u; k < 4u; ++k) sum[slot + 64u * k] = total[k];
}

// Positive mean values, second pass: the sums of all blocks of lines, in order, one invocation per point.
layout(local_size_x = 64) in;

layout(std430, binding = 0) restrict buffer Totals { float total[]; };      // 64 * (4 + parts) for each group
layout(std430, binding = 1) writeonly restrict buffer Seen { vec4 seen[]; };  // 2 for each point, see pmvc_near
layout(std430, binding = 5) readonly restrict buffer Groups { uvec4 group[]; };
layout(std430, binding = 7) readonly restrict buffer Sums { float sum[]; };

uniform uint blocks;       // in this chunk
uniform bool is_first;     // there are no earlier sums

// The standard error of the colour, in its worst channel, if the blocks were independent of each other.
float scatter(uint slot, uint stride, vec4 mean) {
  vec3 squares = vec3(0.0);
  for (uint block = 0u; block < blocks; ++block) {
    uint at = slot + stride * block;
    vec3 off = vec3(sum[at], sum[at + 64u], sum[at + 128u]) - mean.rgb * sum[at + 192u];
    squares += off * off;
  }
  float most = max(squares.x, max(squares.y, squares.z));
  return blocks > 1u && mean.w > 0.0 ? sqrt(most * float(blocks) / float(blocks - 1u)) / mean.w : 0.0;
}

void main() {
  uvec4 sizes = group[2u * gl_WorkGroupID.x], begins = group[2u * gl_WorkGroupID.x + 1u];
  uint lane = gl_LocalInvocationID.x;
  if (lane >= sizes.x) return;
  uint parts = sizes.y, stride = 64u * (4u + parts), slot = sizes.z + lane, mine = begins.w + lane;

  // Add this chunk's blocks to the earlier sums; keep the part with the largest weight, the lowest one of equals.
  vec4 all = vec4(0.0);
  uint heaviest = 0u;
  float heaviest_weight = -1.0;
  for (uint k = 0u; k < 4u + parts; ++k) {
    float of_chunk = 0.0;
    for (uint block = 0u; block < blocks; ++block) of_chunk += sum[slot + stride * block + 64u * k];
    float so_far = (is_first ? 0.0 : total[mine + 64u * k]) + of_chunk;
    total[mine + 64u * k] = so_far;
    if (k < 4u) {
      all[k] = so_far;
    } else if (so_far > heaviest_weight) {
      heaviest = k - 4u;
      heaviest_weight = so_far;
    }
  }

  vec4 mean = all.w > 0.0 ? vec4(all.rgb / all.w, all.w) : vec4(0.0);
  uint at = 2u * (64u * gl_WorkGroupID.x + lane);
  seen[at] = mean;
  seen[at + 1u] = vec4(float(heaviest), scatter(slot, stride, mean), 0.0, 0.0);
}

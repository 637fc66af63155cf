// Guides of texture detail at any place of a cut face: the mirror of generator/cut/section/guide_lattice.cpp.
uniform samplerBuffer guide_lattices;  // render/gl/lattice_texels.h

// A node, counted from the lowest; above a kilometre where nothing is known.
vec4 guide_node(ivec3 n, ivec3 blocks, int table) {
  ivec3 block = n >> 2, own = n & 3;
  int row = int(texelFetch(guide_lattices, 64 * table + (block.z * blocks.y + block.y) * blocks.x + block.x).x);
  if (row < 0) return vec4(1e9);
  return texelFetch(guide_lattices, 64 * row + (own.z * 4 + own.y) * 4 + own.x);
}

// The way to the skin and the depth of the layer at a place of a solid; 0 where it has none, or nothing `counts`.
vec4 way_layer_at(int solid, vec3 position, bool counts) {
  vec4 head = texelFetch(guide_lattices, 3 * solid);
  if (!counts || head.y < 0.0) return vec4(0.0);
  ivec3 low = ivec3(texelFetch(guide_lattices, 3 * solid + 1).xyz);
  ivec3 count = ivec3(texelFetch(guide_lattices, 3 * solid + 2).xyz), blocks = (count + 3) >> 2;
  vec3 node = position / head.x - 0.5, cell = floor(node), t = node - cell;
  ivec3 n = clamp(ivec3(cell) - low, ivec3(0), count - 2);
  vec4 sum = vec4(0.0);
  int i = 0;
  do {
    ivec3 beside = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 weight = mix(1.0 - t, t, vec3(beside));
    sum += weight.x * weight.y * weight.z * guide_node(n + beside, blocks, int(head.y));
  } while (++i < 8);
  return abs(sum.w) < 1e3 ? sum : vec4(0.0);
}

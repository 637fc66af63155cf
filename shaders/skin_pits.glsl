// The pits that parts lie in on skins: the mirror of render/style/skin_pits.cpp.

// For each solid where its grid begins, or -1; then the grids (SkinPits::texels()), whose lists begin counted from them.
uniform samplerBuffer pits;

// Within the fruit: the slope of the height; w: how far inside a pit, 0..1.
vec4 pit_at(int solid, vec3 position) {
  int first = int(texelFetch(pits, solid).x);
  if (first < 0) return vec4(0.0);
  vec4 grid = texelFetch(pits, first);
  ivec3 count = ivec3(texelFetch(pits, first + 1).xyz), cell = ivec3(floor((position - grid.xyz) / grid.w));
  if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, count))) return vec4(0.0);
  vec4 list = texelFetch(pits, first + 2 + (cell.x * count.y + cell.y) * count.z + cell.z);
  vec4 found = vec4(0.0);
  for (int i = 0; i < int(list.y); ++i) {
    int at = first + int(list.x) + 2 * i;
    vec4 pit = texelFetch(pits, at);
    vec3 away = (position - pit.xyz) / pit.w;
    float left = max(1.0 - dot(away, away), 0.0);
    found.xyz += away * (4.0 * texelFetch(pits, at + 1).x * left / pit.w);
    found.w = max(found.w, left * left);
  }
  return found;
}

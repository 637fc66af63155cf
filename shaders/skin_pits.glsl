// Pits and raised spots of skins: the mirror of render/style/skin_pits.cpp.

// For each solid the start of its grid, or -1; then the grids (SkinPits::texels()); starts of lists are relative to
// their grid.
uniform samplerBuffer pits;
const int texels_of_pit = 2, texels_of_spot = 6;
const float spot_step = 1.0 / 128.0;

// A spot at a place: the mirror of cover_of (generator/surface/sweep/spot.cpp).
float spot_cover(int at, vec3 position, vec3 normal) {
  vec4 middle = texelFetch(pits, at), tangent = texelFetch(pits, at + 1), up = texelFetch(pits, at + 2);
  vec3 away = position - middle.xyz;
  float facing = max(0.5 * (1.0 + dot(normal, up.xyz)), 1e-6);
  float along = dot(away, tangent.xyz), across = dot(away, cross(up.xyz, tangent.xyz));
  float shortened = along / tangent.w;
  float chord = sqrt(max(0.0, dot(away, away) - along * along + shortened * shortened));

  // The outline: the distance of the rim in this direction.
  vec2 flat_way = vec2(shortened, across);
  vec2 direction = flat_way / max(length(flat_way), 1e-12), power = direction;
  vec4 first = texelFetch(pits, at + 3), second = texelFetch(pits, at + 4);
  vec2 waves[4] = vec2[4](first.xy, first.zw, second.xy, second.zw);
  float rim = 1.0;
  for (int k = 0; k < 4; ++k) {
    power = vec2(power.x * direction.x - power.y * direction.y, power.x * direction.y + power.y * direction.x);
    rim += dot(waves[k], power);
  }
  float share = chord / (sqrt(sqrt(facing)) * middle.w * rim);
  float left = clamp((1.0 - share) / up.w, 0.0, 1.0);
  return left * left * (3.0 - 2.0 * left);
}

// In the fruit's frame: the slope of the height; w: how far inside a pit, 0..1. `normal` is in the same frame.
vec4 pit_at(int solid, vec3 position, vec3 normal) {
  int first = int(texelFetch(pits, solid).x);
  if (first < 0) return vec4(0.0);
  vec4 grid = texelFetch(pits, first);
  ivec3 count = ivec3(texelFetch(pits, first + 1).xyz), cell = ivec3(floor((position - grid.xyz) / grid.w));
  if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, count))) return vec4(0.0);
  vec4 list = texelFetch(pits, first + 2 + (cell.x * count.y + cell.y) * count.z + cell.z);
  vec4 found = vec4(0.0);
  for (int i = 0; i < int(list.y); ++i) {
    int at = first + int(list.x) + texels_of_pit * i;
    vec4 pit = texelFetch(pits, at);
    vec3 away = (position - pit.xyz) / pit.w;
    float left = max(1.0 - dot(away, away), 0.0);
    found.xyz += away * (4.0 * texelFetch(pits, at + 1).x * left / pit.w);
    found.w = max(found.w, left * left);
  }
  vec3 right = normalize(cross(abs(normal.y) < 0.8 ? vec3(0, 1, 0) : vec3(1, 0, 0), normal));
  vec3 up = cross(normal, right);
  for (int i = 0; i < int(list.z); ++i) {
    int at = first + int(list.x) + texels_of_pit * int(list.y) + texels_of_spot * i;
    float relief = texelFetch(pits, at + 5).x;
    float size = texelFetch(pits, at).w * min(texelFetch(pits, at + 1).w, 1.0) * spot_step;
    float here = spot_cover(at, position, normal);
    vec2 growth = vec2(spot_cover(at, position + size * right, normal), spot_cover(at, position + size * up, normal)) - here;
    found.xyz += relief / size * (growth.x * right + growth.y * up);
    found.w = relief < 0.0 ? max(found.w, here) : found.w;
  }
  return found;
}

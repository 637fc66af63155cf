// How much of the sky and of the light reaches a pixel: ambient obscurance [McGuire et al. 2011] from the depth of its
// surroundings, and a shadow map with a filter radius that grows with the distance of the occluder [Fernando 2005].
#include "gbuffer.glsl"

uniform usampler2D ids;
uniform sampler2D depth;
uniform sampler2D normal_line;
uniform sampler2D shadow_map;
uniform int samples_per_side;
uniform vec2 tangent;         // of half the field of view
uniform mat4 view;            // scene to camera
uniform mat4 camera_to_light; // camera to the shadow map's box, 0..1 along each axis
uniform float reach;          // metres over which objects occlude each other's sky
uniform float light_size;     // share of the shadow map's side per unit of its depth
uniform vec2 shadow_bias;     // metres along the normal; depth
uniform vec2 strengths;       // of occlusion by surroundings; of shadows
uniform sampler2D lowest;     // lowest height of objects over the table, as a share of its reach; 1: nothing
uniform mat4 camera_to_table; // camera to that map's box, 0..1 along each axis
uniform vec2 table_reach;     // reach of occlusion of the table: metres, and a share of the map's side

layout(location = 0) out vec4 light;  // sky, light, distance

// True if a pixel shows only paper and table: none of its samples is on a piece.
bool is_paper(ivec2 first) {
  uint pieces = 0u;
  int i = 0;
  do pieces |= instance_of(texelFetch(ids, first + ivec2(i % samples_per_side, i / samples_per_side), 0).r);
  while (++i < samples_per_side * samples_per_side);
  return pieces == 0u;
}

vec3 camera_point(ivec2 sample_at, vec2 size, out float distance_to) {
  distance_to = distance_from_depth(texelFetch(depth, sample_at, 0).r);
  vec2 ndc = 2.0 * (vec2(sample_at) + 0.5) / size - 1.0;
  return vec3(ndc * tangent, -1.0) * distance_to;
}

#ifdef WINDOW
const int shadow_finds = 16, shadow_looks = 32;
uniform float juice_reach;  // metres

// The share of a small circle around a place on the table above which an object nearly touches the table.
float juice_at(vec3 p) {
  vec2 direction = vec2(1.0, 0.0);  // the same everywhere, because the result is not smoothed
  vec2 here = (camera_to_table * vec4(p, 1.0)).xy;
  float near = 0.0;
  const int count = 32;
  int i = 0;
  do {
    vec2 aside = table_reach.y * juice_reach / table_reach.x * spiral_radius(i, count) * direction;
    float height = texture(lowest, here + aside).r;
    near += 1.0 - smoothstep(0.0004, 0.0012, height * table_reach.x);
    direction = golden_angle * direction;
  } while (++i < count);
  return near / float(count);
}
#else
const int shadow_finds = 8, shadow_looks = 14;
#endif

float sky_seen(vec3 p, vec3 n, float distance_to, ivec2 at, vec2 size, vec2 direction) {
  const int count = 20;
  float radius = reach / distance_to / tangent.y * 0.5 * size.y;  // in samples
  float taken = 0.0;
  int i = 0;
  do {
    vec2 step_away = (float(i) + 0.5) / float(count) * direction;  // denser near the point, because contacts count most
    direction = golden_angle * direction;
    ivec2 there = clamp(at + ivec2(step_away * radius), ivec2(0), ivec2(size) - 1);
    float beyond;
    vec3 v = camera_point(there, size, beyond) - p;
    float squared = dot(v, v);
    float rise = dot(v, n) - 0.0015 * distance_to;
    float fade = max(0.0, 1.0 - squared / (reach * reach));
    // An empty pixel is no wall, so that the table's far end stays clean.
    fade = beyond < 0.999 * depth_range.y ? fade : 0.0;
    taken += fade * fade * max(rise, 0.0) * inversesqrt(squared + 1e-4 * reach * reach);
  } while (++i < count);
  return clamp(1.0 - 3.4 * taken / float(count), 0.0, 1.0);
}

#ifdef WINDOW
// The same over a fifth of the reach, for contacts of pieces.
float sky_nearby(vec3 p, vec3 n, float distance_to, ivec2 at, vec2 size, vec2 direction) {
  const int count = 16;
  float near = 0.2 * reach, radius = near / distance_to / tangent.y * 0.5 * size.y, taken = 0.0;
  int i = 0;
  do {
    ivec2 there = clamp(at + ivec2(spiral_radius(i, count) * radius * direction), ivec2(0), ivec2(size) - 1);
    direction = golden_angle * direction;
    float beyond;
    vec3 v = camera_point(there, size, beyond) - p;
    float squared = dot(v, v), fade = max(0.0, 1.0 - squared / (near * near));
    taken += fade * max(dot(v, n) - 0.0015 * distance_to, 0.0) * inversesqrt(squared + 1e-4 * near * near);
  } while (++i < count);
  return clamp(1.0 - 2.2 * taken / float(count), 0.0, 1.0);
}
#endif

// The share of the picture's neighbourhood that belongs to another, slightly nearer piece. Painters darken such places,
// so that each piece stands out from the one behind it [Luft et al. 2006]. Paper stays clean.
float behind_others(float distance_to, ivec2 at, vec2 size, vec2 direction) {
  uint mine = instance_of(texelFetch(ids, at, 0).r);
  if (mine == 0u) return 0.0;
  const int count = 12;
  float standing = 0.0, all = 0.0;
  int i = 0;
  do {
    float away = spiral_radius(i, count);
    ivec2 there = clamp(at + ivec2(away * 0.02 * size.y * direction), ivec2(0), ivec2(size) - 1);
    direction = golden_angle * direction;
    float gap = distance_to - distance_from_depth(texelFetch(depth, there, 0).r);
    float share = 1.0 - 0.8 * away;
    all += share;
    if (instance_of(texelFetch(ids, there, 0).r) != mine)
      standing += share * smoothstep(0.05 * reach, 0.35 * reach, gap) * (1.0 - smoothstep(1.5 * reach, 4.0 * reach, gap));
  } while (++i < count);
  return standing / all;
}

// How much sky reaches the table beside and under pieces, whether or not the eye sees them, so that each piece visibly
// stands and does not hover.
float sky_over_table(vec3 p, vec2 direction) {
  const int count = 24;
  vec2 here = (camera_to_table * vec4(p, 1.0)).xy;
  float taken = 0.0;
  int i = 0;
  do {
    float squared = (float(i) + 0.5) / float(count);
    float height = texture(lowest, here + table_reach.y * sqrt(squared) * direction).r;
    taken += max(0.0, 1.0 - sqrt(squared + height * height));
    direction = golden_angle * direction;
  } while (++i < count);
  return clamp(1.0 - 3.0 * taken / float(count), 0.0, 1.0);
}

float light_seen(vec3 p, vec3 n, vec2 direction) {
  vec3 q = (camera_to_light * vec4(p + n * shadow_bias.x, 1.0)).xyz;
  if (any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0)))) return 1.0;
  float here = q.z - shadow_bias.y;

  // The distance of the occluder.
  float gap = 0.0, found = 0.0;
  vec2 way = direction;
  int i = 0;
  do {
    float there = texture(shadow_map, q.xy + 0.03 * spiral_radius(i, shadow_finds) * way).r;
    way = golden_angle * way;
    if (there < here) {
      gap += here - there;
      found += 1.0;
    }
  } while (++i < shadow_finds);
  if (found == 0.0) return 1.0;
  float radius = clamp(light_size * gap / found, 0.002, 0.03);
  float seen = 0.0;
  i = 0;
  do {
    seen += step(here, texture(shadow_map, q.xy + radius * spiral_radius(i, shadow_looks) * direction).r);
    direction = golden_angle * direction;
  } while (++i < shadow_looks);
  return seen / float(shadow_looks);
}

void main() {
  vec2 size = vec2(textureSize(depth, 0));
  ivec2 first = ivec2(gl_FragCoord.xy) * samples_per_side, at = first + samples_per_side / 2;

  // The last pass finds fruit by a depth test, in whole blocks of pixels; its rows run down.
  gl_FragDepth = is_paper(ivec2(first.x, int(size.y) - samples_per_side - first.y)) ? 1.0 : 0.0;
  if (texelFetch(depth, at, 0).r == 1.0) {
    light = vec4(1.0, 1.0, depth_range.y, 0.0);
    return;
  }
  float distance_to;
  vec3 p = camera_point(at, size, distance_to);
  vec3 n = mat3(view) * texelFetch(normal_line, at, 0).xyz;
  vec2 direction = first_direction(gl_FragCoord.xy);
  vec2 seen = vec2(sky_seen(p, n, distance_to, at, size, direction), light_seen(p, n, direction));
  if (table_reach.x > 0.0 && instance_of(texelFetch(ids, at, 0).r) == 0u) seen.x *= sky_over_table(p, direction);
#ifdef WINDOW
  seen.x = min(seen.x, mix(1.0, sky_nearby(p, n, distance_to, at, size, direction), 0.7));
#endif
  seen.x *= 1.0 - 1.1 * behind_others(distance_to, at, size, direction);
  light = vec4(clamp(1.0 - strengths * (1.0 - seen), 0.0, 1.0), distance_to, 0.0);
#ifdef WINDOW
  bool is_table = table_reach.x > 0.0 && instance_of(texelFetch(ids, at, 0).r) == 0u;
  if (is_table && juice_reach > 0.0) light.w = juice_at(p);
#endif
}

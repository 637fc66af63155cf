// The table: the shadow on it, and how much of the light reaches a place.
#ifdef VERTEX
#ifdef GROUND
uniform mat4 camera;
uniform vec4 ground;  // middle, height in y; half its side
out vec3 there;
void main() {
  vec2 st = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  there = vec3(ground.x + st.x * ground.w, ground.y, ground.z + st.y * ground.w);
  gl_Position = camera * vec4(there, 1.0);
}
#endif
#endif

#ifdef FRAGMENT
#include "lit.glsl"

// On cut faces that a scene's pieces already had, pages do not know the distance of a place in a gel from its walls:
// millimetres used instead.
const float gel_rim = 1.0;
uniform highp sampler2D sun_map, sky_map;  // depths seen from the light, and from below the table
uniform mat4 to_sun, to_sky;
uniform vec2 shadow_ways;  // of the sun's map: maximum softening of edges; depth bias
uniform vec4 ground_plane; // height of the table; cells over which it darkens; strength of shadows; of occlusion

float turn_at(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

vec2 spiral(int i, int count, float turn) {
  float angle = 2.3999632 * float(i) + 6.2831853 * turn;
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// The visible share of the light's disc: a first search finds the occluders, whose distance softens edges [Fernando
// 2005].
float sun_seen(vec3 p, vec3 n) {
  vec3 q = (to_sun * vec4(p + 0.8 * n, 1.0)).xyz * 0.5 + 0.5;
  if (any(lessThan(q, vec3(0.0))) || any(greaterThan(q, vec3(1.0)))) return 1.0;
  float turn = turn_at(gl_FragCoord.xy), here = q.z - shadow_ways.y, gap = 0.0, found = 0.0;
  int i = 0;
  do {
    float other = textureLod(sun_map, q.xy + shadow_ways.x * spiral(i, 8, turn), 0.0).r;
    if (other < here) {
      gap += here - other;
      found += 1.0;
    }
  } while (++i < 8);
  if (found == 0.0) return 1.0;
  float radius = clamp(0.25 * gap / found, 0.0015, shadow_ways.x), lit = 0.0;
  i = 0;
  do lit += step(here, textureLod(sun_map, q.xy + radius * spiral(i, 16, turn), 0.0).r);
  while (++i < 16);
  return mix(1.0, lit / 16.0, ground_plane.z);
}

// Near the table less of the sky is visible, least for surfaces that face down.
float sky_seen(vec3 p, vec3 n) {
  float near = 1.0 - clamp((p.y - ground_plane.x) / ground_plane.y, 0.0, 1.0);
  return 1.0 - ground_plane.w * (0.42 * near * (0.55 - 0.45 * n.y) + 0.12 * (0.5 - 0.5 * n.y));
}

// AS_IS: nothing to compile for a style that does not change colours.
vec3 painted(vec3 color, vec2 how) {
#ifdef AS_IS
  return clamp(color, 0.0, 1.0);
#else
  vec3 lab = to_oklab(max(color, 0.0));
  return clamp(from_oklab(vec3(lab.x + how.y, lab.yz * how.x)), 0.0, 1.0);
#endif
}

#ifdef GROUND
in vec3 there;
uniform vec4 wash;  // colour of shadow on white paper; strength
layout(location = 0) out vec4 pixel;

#ifndef QUICK
// Objects above the table occlude its sky, more if they are lower.
float open_sky() {
  vec2 at = (to_sky * vec4(there, 1.0)).xy * 0.5 + 0.5;
  float turn = turn_at(gl_FragCoord.xy), taken = 0.0;
  int i = 0;
  do {
    vec2 away = spiral(i, 20, turn);
    float height = textureLod(sky_map, at + 0.13 * away * length(away), 0.0).r;
    taken += height >= 1.0 ? 0.0 : 1.0 / (1.0 + 900.0 * height * height);
  } while (++i < 20);
  return 1.0 - taken / 20.0;
}
#endif

#ifdef QUICK
// Shadows as sharp as their map; only objects right above occlude the sky.
vec2 seen() {
  vec2 sun = (to_sun * vec4(there, 1.0)).xy * 0.5 + 0.5;
  float height = textureLod(sky_map, (to_sky * vec4(there, 1.0)).xy * 0.5 + 0.5, 0.0).r;
  return vec2(textureLod(sun_map, sun, 0.0).r < 1.0 ? 1.0 - ground_plane.z : 1.0, height < 1.0 ? 0.4 : 1.0);
}
#else
vec2 seen() { return vec2(sun_seen(there, vec3(0.0, 1.0, 0.0)), open_sky()); }
#endif

void main() {
  vec2 parts = seen();
  float sun_part = parts.x, sky_part = mix(1.0, parts.y, ground_plane.w);
  vec3 shade = mix(wash.rgb, vec3(1.0), sun_part) * mix(0.72 * wash.rgb, vec3(1.0), sky_part);
  shade = mix(vec3(1.0), shade, wash.a);
  // The paper is behind the canvas, so draw how much of it the wash hides.
  float dark = 1.0 - dot(srgb_from_linear(shade), vec3(1.0 / 3.0));
  pixel = vec4(0.30 * srgb_from_linear(wash.rgb) * dark, dark);
}
#endif
#endif

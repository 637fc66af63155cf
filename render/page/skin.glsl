// The skin, the walls of hollows, and the cut faces that a scene's piece already had. SHOW: lit. QUICK: plain, with
// less to compile. HULL: the outline, a shell drawn slightly larger behind. DEPTH and PICK: for shadows and the
// pointer. WITHIN: seen from inside, through the narrow gap between skin and cut face. CROSSED: where rays from a
// knife's face pass through it.
#ifdef VERTEX
layout(location = 0) in vec3 position;  // cells of the grid
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
layout(location = 3) in float part;  // plus 1000 on cut faces
layout(location = 4) in vec3 outwards;  // like normal, but the same for all corners at a place; any length
uniform mat4 piece, camera;
uniform vec3 face_origin, face_u, face_v, face_n;  // of CROSSED: cells; u and v as long as half the face
uniform vec3 outline;  // half the picture's width and height, pixels; the line's width
centroid out vec3 in_fruit;
centroid out vec3 fruit_normal, bare;
flat out float tag, on_cut;
void main() {
  in_fruit = position;
  fruit_normal = normal;
  bare = color;
  on_cut = step(999.5, part);
  tag = part - 1000.0 * on_cut;
  gl_Position = camera * piece * vec4(position, 1.0);
#ifdef CROSSED
  vec3 away = position - face_origin;
  gl_Position = vec4(dot(away, face_u) / dot(face_u, face_u), dot(away, face_v) / dot(face_v, face_v), 0.0, 1.0);
#endif
#ifdef HULL
  vec2 way = (camera * vec4(mat3(piece) * outwards, 0.0)).xy * outline.xy;
  gl_Position.xy += way / max(length(way), 1e-4) * outline.z / outline.xy * gl_Position.w;
  gl_Position.z += 2e-4 * gl_Position.w;
#endif
}
#endif

#ifdef FRAGMENT
centroid in vec3 in_fruit;
centroid in vec3 fruit_normal, bare;
flat in float tag, on_cut;
uniform uvec2 left_out;  // bits of parts that are drawn elsewhere
#include "cut_away.glsl"

bool is_away() {
  uint bit = uint(tag + 0.5);
  if (on_cut < 0.5 && ((bit < 32u ? left_out.x : left_out.y) >> (bit & 31u) & 1u) != 0u) return true;
  return is_cut_away(in_fruit, -1);
}

#ifdef DEPTH
layout(location = 0) out vec4 nothing;
void main() {
  if (is_away()) discard;
  nothing = vec4(1.0);
}
#endif

#ifdef PICK
uniform vec2 body;  // its number's two bytes, of 255
layout(location = 0) out vec4 picked;
void main() {
  if (is_away()) discard;
  picked = vec4((tag + 1.0) / 255.0, 0.5 + 0.5 * on_cut, body);
}
#endif

#ifdef CROSSED
uniform vec3 face_origin, face_u, face_n;
uniform int knife_number;
layout(location = 0) out vec4 ways;  // out of the body, into it
void main() {
  vec3 away = in_fruit - face_origin;
  if (dot(away, face_n) < profile_at(knife_number, dot(away, face_u) / dot(face_u, face_u))) discard;
  ways = gl_FrontFacing ? vec4(1.0 / 255.0, 0.0, 0.0, 0.0) : vec4(0.0, 1.0 / 255.0, 0.0, 0.0);
}
#endif

#if defined(HULL) || defined(WITHIN)
uniform vec4 ink;
layout(location = 0) out vec4 pixel;
vec3 encoded(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
void main() {
  if (is_away()) discard;
#ifdef HULL
  pixel = vec4(encoded(ink.rgb), 1.0);
#else
  pixel = vec4(encoded(mix(bare, ink.rgb, 0.7)), 1.0);
#endif
}
#endif

#ifdef SHOW
#include "ground.glsl"
uniform mat4 piece;
uniform vec3 eye;
uniform vec4 lattice;
uniform bool painted_noise;
uniform vec2 paint;
uniform vec4 ink;
layout(location = 0) out vec4 pixel;

// Only pieces of scenes have cut faces in their meshes; for others nothing of them must be compiled.
#ifdef PIECES
#define IS_CUT (on_cut > 0.5)
#else
#define IS_CUT false
#endif

vec3 shown(float footprint) {
  vec3 there = (piece * vec4(in_fruit, 1.0)).xyz, to_eye = normalize(eye - there);
  vec3 n = normalize(mat3(piece) * fruit_normal);
#ifdef QUICK
  return painted(dull_color(clamp(bare, 0.0, 1.0), n, vec2(sky_seen(there, n), 1.0), false), paint);
#else
  vec3 position = lattice.xyz + lattice.w * in_fruit;
  vec3 color = clamp(bare, 0.0, 1.0);
  if (painted_noise) color = modulated(color, position, footprint, 0);
  Seen seen = Seen(sky_seen(there, n), sun_seen(there, n), vec3(0.0), vec3(0.0));
  color = fruit_color(color, n, to_eye, seen, IS_CUT, material_at(tag), position, footprint, gel_rim);
  return painted(color, paint);
#endif
}

void main() {
  float footprint = lattice.w * length(fwidth(in_fruit)) * 0.6;
  bool away = is_away();
  if (away) discard;
  // Software renderers continue after discard; without asking for the colour all loops in it end early.
  vec3 color = bare;
  if (!away) color = shown(footprint);
  pixel = vec4(srgb_from_linear(color), 1.0);
}
#endif
#endif

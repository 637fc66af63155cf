// Cut faces. LOOK: their bare colours, into a texture over the knife's face. WITHIN: removes what lies outside a piece,
// or inside a spared part. WAYS: the distance of each place to the rim of its part along its row. TONE, DETAIL, INK:
// noise, details one by one, lines and slopes. SHOW: the lit face in the picture. DEPTH and PICK: for shadows and the
// pointer.
#ifdef VERTEX
// A strip across the face: flat knives have one column, others many.
uniform int columns;
uniform vec4 box;  // low and high corner of the drawn part of the face, -1 to 1
uniform vec3 face_origin, face_u, face_v, face_n;  // cells of the grid; u and v as long as half the face
uniform mat4 piece, camera;
uniform int knife_number;
uniform highp sampler2D profiles;
out vec2 place;
centroid out vec3 in_fruit;
void main() {
#if defined(LOOK) || defined(WITHIN) || defined(WAYS) || defined(TONE) || defined(DETAIL) || defined(INK)
  vec2 st = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  place = st;
  in_fruit = vec3(0.0);
  gl_Position = vec4(st, 0.0, 1.0);
#else
  vec2 st = mix(box.xy, box.zw, vec2(float(gl_VertexID / 2) / float(columns), float(gl_VertexID & 1)));
  int column = int(round((st.x * 0.5 + 0.5) * 255.0));
  float height = texelFetch(profiles, ivec2(column, knife_number), 0).r;
  place = st;
  in_fruit = face_origin + st.x * face_u + st.y * face_v + height * face_n;
  gl_Position = camera * piece * vec4(in_fruit, 1.0);
#endif
}
#endif

#ifdef FRAGMENT
in vec2 place;
centroid in vec3 in_fruit;
uniform vec3 face_origin, face_u, face_v, face_n;
uniform int knife_number;
#include "cut_away.glsl"

#ifndef LOOK
#include "noise.glsl"
#endif
#if defined(WAYS) || defined(INK) || defined(SHOW)
#include "material.glsl"
#endif

#ifdef LOOK
#include "look.glsl"
layout(location = 0) out vec4 bare;
layout(location = 1) out vec4 tag;  // 1 + part, of 255
void main() {
  vec3 g = face_origin + place.x * face_u + place.y * face_v + profile_at(knife_number, place.x) * face_n;
  vec3 color;
  int part;
  bool inside = pomona_look(g, color, part);
  bare = vec4(color, inside ? 1.0 : 0.0);
  tag = vec4(inside ? float(part + 1) / 255.0 : 0.0, 0.0, 0.0, 1.0);
}
#endif

#ifdef WITHIN
uniform sampler2D crossed;  // by rays from here: number of exits from the meshes and entries into them, of 255
uniform bool keeps_inside;
layout(location = 0) out vec4 bare;
layout(location = 1) out vec4 tag;
void main() {
  vec4 ways = texelFetch(crossed, ivec2(gl_FragCoord.xy), 0);
  if ((ways.r > ways.g + 0.002) == keeps_inside) discard;
  bare = tag = vec4(0.0);
}
#endif

#if defined(WAYS) || defined(INK)
uniform sampler2D tags;
uniform int reach;    // texels, up to 127: rims farther away are ignored; 0: no part shows them
uniform vec2 texel;   // metres; of the reach, too

float tag_at(ivec2 at) { return texelFetch(tags, clamp(at, ivec2(0), textureSize(tags, 0) - 1), 0).r; }
int material_of(float tag) { return material_texels * int(tag * 255.0 - 0.5); }
float relief_of(float tag) {
  int last = material_of(tag) + 4;
  return texelFetch(materials, last).w;
}

// A gel or a part with a relief.
bool shows_rim(float tag) {
  int first = material_of(tag);
  return tag > 0.0 && (texelFetch(materials, first).w > 0.0034 || relief_of(tag) != 0.0);
}
#endif

#ifdef WAYS
layout(location = 0) out vec4 way;  // texels + 128, of 255: along the row; 0: there is none
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float tag = tag_at(at);
  int found = 0, last = shows_rim(tag) ? reach : 0;
  for (int d = 1; d <= last && found == 0; ++d)
    found = tag_at(at + ivec2(d, 0)) != tag ? d : tag_at(at - ivec2(d, 0)) != tag ? -d : 0;
  way = vec4(found == 0 ? 0.0 : float(found + 128) / 255.0);
}
#endif

#if defined(TONE) || defined(DETAIL)
uniform sampler2D tags;
#endif
#if defined(TONE) || defined(DETAIL) || defined(INK)
uniform sampler2D bare, before, heights;  // before, heights: results of the previous pass
layout(location = 0) out vec4 styled;
layout(location = 1) out vec4 beside;  // of TONE and DETAIL: height, 16 bits; of INK: slopes along u and v, way to the rim

const float highest = 0.002;  // metres
const float steepest = 2.0;
vec4 packed_height(float height) {
  float all = (clamp(height / highest, -1.0, 1.0) * 0.5 + 0.5) * 255.0, high = floor(all);
  return vec4(high / 255.0, all - high, 0.0, 0.0);
}
float height_of(vec4 packed) { return ((packed.x * 255.0 + packed.y) / 255.0 * 2.0 - 1.0) * highest; }

vec4 bare_at(ivec2 at) { return texelFetch(bare, clamp(at, ivec2(0), textureSize(bare, 0) - 1), 0); }
#endif

#if defined(TONE) || defined(DETAIL)
uniform vec4 lattice;  // origin, spacing: metres

vec3 cells_here() {
  return face_origin + place.x * face_u + place.y * face_v + profile_at(knife_number, place.x) * face_n;
}
float footprint_here() { return lattice.w * 2.0 * length(face_u) / float(textureSize(bare, 0).x); }
#endif

#ifdef TONE
void main() {
  vec4 here = bare_at(ivec2(gl_FragCoord.xy));
  if (here.a == 0.0) discard;
  styled = vec4(modulated(here.rgb, lattice.xyz + lattice.w * cells_here(), footprint_here(), 0), 1.0);
  beside = packed_height(0.0);
}
#endif

#ifdef DETAIL
// One detail of cut faces, of a kind known at compile time, like `detailed` in pictures.
uniform int detail_number;
uniform vec4 detail_channel;    // of the shares: 1 for this one
#include "detail.glsl"
uniform highp sampler3D guide;  // to the skin and the depth of the layer, metres; every stride-th node
uniform sampler2D shares;       // by depth and part
uniform float guide_scale;      // from cells to the guide's nodes
uniform vec2 guide_depth;       // the deepest, metres; parts

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 here = bare_at(at);
  if (here.a == 0.0) discard;
  vec3 g = cells_here(), position = lattice.xyz + lattice.w * g;
  vec4 way_layer = texture(guide, (g * guide_scale + 0.5) / vec3(textureSize(guide, 0)));
  float part = texelFetch(tags, at, 0).r * 255.0 - 1.0, depth = clamp(length(way_layer.xyz) / guide_depth.x, 0.0, 1.0);
  float share = dot(texture(shares, vec2((depth * 31.0 + 0.5) / 32.0, (part + 0.5) / guide_depth.y)), detail_channel);
  styled = texelFetch(before, at, 0);
  beside = texelFetch(heights, at, 0);

  // The detail, and its weight for this colour.
  int detail = detail_texels * detail_number;
  vec4 head = texelFetch(detail_styles, detail), form = texelFetch(detail_styles, detail + 2);
  vec4 target = texelFetch(detail_styles, detail + 3), near = texelFetch(detail_styles, detail + 4), last = texelFetch(detail_styles, detail + 6);
  vec3 away = to_oklab(here.rgb) - near.xyz;
  if (form.w > 0.0) share *= exp(-dot(away, away) / (2.0 * form.w * form.w));

  if (share > 1e-3) {
#ifdef EXAMPLES
    vec4 shown = example_color(detail, position, footprint_here(), way_layer);
    styled.rgb = with_example(detail, styled.rgb, shown.rgb, head.z * share);
    vec2 value = vec2(shown.a, 0.0);
#else
    vec2 value = shown_pattern(detail, KIND, position, footprint_here(), way_layer);
    vec3 lab = to_oklab(styled.rgb);
    lab += value.x * head.z * share * (head.w > 0.0 ? target.xyz - lab : target.xyz);
    lab.x += value.y * abs(head.z * share) * 0.12;
    styled.rgb = clamp(from_oklab(lab), 0.0, 1.0);
#endif
    beside = packed_height(height_of(beside) + last.w * share * value.x);
  }
}
#endif

#ifdef INK
uniform vec4 ink;         // colour, opacity
uniform float ink_width;  // texels to either side
uniform sampler2D ways;
uniform bool has_heights;

// The jump of the bare colour between two sides of the place, in OKLab.
float jump(ivec2 at, vec2 way) {
  vec4 a = bare_at(at + ivec2(round(way))), b = bare_at(at - ivec2(round(way)));
  return a.a * b.a > 0.0 ? length(to_oklab(a.rgb) - to_oklab(b.rgb)) : 0.0;
}

// The direction away from the nearest point of the part's rim, and its distance, metres.
vec3 to_rim(ivec2 at) {
  float tag = tag_at(at), nearest = float(reach * reach);
  vec2 way = vec2(0.0);
  int last = shows_rim(tag) ? reach : 0;
  for (int i = 0; i <= 2 * last; ++i) {
    // Row by row, alternately up and down; beyond the part's end straight above or below no row is nearer.
    int d = (i & 1) == 0 ? -(i / 2) : (i + 1) / 2;
    if (float(d * d) >= nearest) break;
    ivec2 there = at + ivec2(0, d);
    bool ends = tag_at(there) != tag;
    float coded = floor(texelFetch(ways, clamp(there, ivec2(0), textureSize(ways, 0) - 1), 0).r * 255.0 + 0.5);
    vec2 towards = vec2(ends ? 0.0 : coded - 128.0, d);
    if ((ends || coded > 0.0) && dot(towards, towards) < nearest) {
      nearest = dot(towards, towards);
      way = towards;
    }
  }
  return nearest < float(reach * reach) ? vec3(-way / sqrt(nearest), max(sqrt(nearest) - 0.5, 0.0) * texel.x) : vec3(0.0, 0.0, texel.y);
}

vec2 slope_of_heights(ivec2 at) {
  float here = height_of(texelFetch(heights, at, 0));
  vec2 slope = vec2(0.0);
  int axis = 0;
  do {
    float rise = 0.0, count = 0.0;
    int way = -1;
    do {
      ivec2 there = at + way * ivec2(1 - axis, axis);
      float is_there = bare_at(there).a == 0.0 ? 0.0 : 1.0;
      rise += is_there * float(way) * (height_of(texelFetch(heights, there, 0)) - here);
      count += is_there;
    } while ((way += 2) <= 1);
    if (count > 0.0) slope += rise / (count * texel.x) * vec2(1 - axis, axis);
  } while (++axis < 2);
  return slope;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  if (bare_at(at).a == 0.0) {
    // Beyond the rim the colours continue, for smaller scales of the texture.
    vec4 sum = vec4(0.0);
    int i = 0;
    do {
      int k = i < 4 ? i : i + 1;
      vec4 neighbour = bare_at(at + 2 * ivec2(k % 3 - 1, k / 3 - 1));
      sum += neighbour * neighbour.a;
    } while (++i < 8);
    styled = vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), 0.0);
    beside = vec4(0.5, 0.5, 1.0, 1.0);
    return;
  }
  vec3 color = texelFetch(before, at, 0).rgb;
  if (ink.a > 0.0) {
    // The pressure of the pen varies.
    float hand = 0.75 + 0.5 * gradient_noise(vec3(place * 9.0, 0.5), 77u);
    float reach = max(ink_width * hand, 0.75);
    float sharpest = max(max(jump(at, vec2(reach, 0.0)), jump(at, vec2(0.0, reach))),
                         max(jump(at, 0.7 * vec2(reach, reach)), jump(at, 0.7 * vec2(reach, -reach))));
    color = mix(color, ink.rgb, ink.a * hand * smoothstep(0.07, 0.17, sharpest));
  }
  styled = vec4(color, 1.0);
  vec3 rim = to_rim(at);
  vec2 slope = has_heights ? slope_of_heights(at) : vec2(0.0);
  float relief = relief_of(tag_at(at));
  // A part with relief rises from its rim like a stretched quarter of a circle (render/style/face_relief.h).
  if (relief != 0.0) slope += sign(relief) * max(1.0 - rim.z / abs(2.0 * relief), 0.0) * rim.xy;
  beside = vec4(slope / steepest * 0.5 + 0.5, rim.z / texel.y, 1.0);
}
#endif

#if defined(SHOW) || defined(DEPTH) || defined(PICK)
uniform sampler2D styled, tags;
#endif

#ifdef DEPTH
layout(location = 0) out vec4 nothing;
void main() {
  if (is_cut_away(in_fruit, knife_number) || textureLod(styled, place * 0.5 + 0.5, 0.0).a < 0.5) discard;
  nothing = vec4(1.0);
}
#endif

#ifdef PICK
uniform vec2 body;  // its number's two bytes, of 255
layout(location = 0) out vec4 picked;
void main() {
  float tag = textureLod(tags, place * 0.5 + 0.5, 0.0).r;
  if (is_cut_away(in_fruit, knife_number) || tag == 0.0) discard;
  picked = vec4(tag, 1.0, body);
}
#endif

#ifdef SHOW
#include "ground.glsl"
uniform mat4 piece;
uniform vec3 eye;          // in the picture's space, cells
uniform vec4 lattice;
uniform float side;        // +1: seen from where the normal points
uniform vec4 ink;
uniform float rim_width;   // pixels
uniform vec2 paint;        // saturation, lightness
uniform float outline;     // 1 if rims have a line
uniform sampler2D slopes;  // along u and v, from -2 to 2; distance of the part's rim, of 4 mm
layout(location = 0) out vec4 pixel;

// The rim: how much of the neighbourhood is outside the fruit.
float air_around(vec2 at, vec2 dx, vec2 dy) {
  float air = 0.0;
  int i = 0, ways = outline > 0.0 ? 12 : 1;
  do {
    float turn = 6.2831853 * float(i) / 12.0;
    vec2 step_away = cos(turn) * dx + sin(turn) * dy;
    air = max(air, 1.0 - textureLod(styled, at + step_away, 0.0).a);
  } while (++i < ways);
  return air;
}

#ifdef QUICK
vec3 shown(vec2 at, vec2 dx, vec2 dy, float footprint) {
  vec3 n = normalize(mat3(piece) * face_n) * side, there = (piece * vec4(in_fruit, 1.0)).xyz;
  return painted(dull_color(textureGrad(styled, at, dx, dy).rgb, n, vec2(sky_seen(there, n), 1.0), true), paint);
}
#else
vec3 shown(vec2 at, vec2 dx, vec2 dy, float footprint) {
  float slope = (profile_at(knife_number, place.x + 0.008) - profile_at(knife_number, place.x - 0.008)) / 0.016;
  vec3 n = normalize(face_n - slope * face_u / dot(face_u, face_u));
  // Raised details are raised on both faces of a cut.
  vec4 relief = textureGrad(slopes, at, dx, dy);
  vec2 rise = relief.xy * 4.0 - 2.0;
  n = normalize(mat3(piece) * n) * side;
  n = normalize(n - mat3(piece) * (rise.x * normalize(face_u) + rise.y * normalize(face_v)) / length(mat3(piece) * normalize(face_n)));
  vec3 position = lattice.xyz + lattice.w * in_fruit, there = (piece * vec4(in_fruit, 1.0)).xyz;
  vec3 to_eye = normalize(eye - there);
  float part = texelFetch(tags, ivec2(at * vec2(textureSize(tags, 0))), 0).r * 255.0 - 1.0;
  Seen seen = Seen(sky_seen(there, n), sun_seen(there, n), vec3(0.0), vec3(0.0));
  vec3 color = fruit_color(textureGrad(styled, at, dx, dy).rgb, n, to_eye, seen, true, material_at(max(part, 0.0)), position, footprint, 4.0 * relief.z);
  float hand = 0.7 + 0.6 * gradient_noise(vec3(place * 7.0, 0.5), 78u);
  float air = air_around(at, rim_width * hand * dx, rim_width * hand * dy);
  return mix(painted(color, paint), ink.rgb, outline * smoothstep(0.35, 0.65, air) * 0.92);
}
#endif

void main() {
  vec2 at = place * 0.5 + 0.5, dx = dFdx(at), dy = dFdy(at);
  float footprint = lattice.w * length(fwidth(in_fruit)) * 0.6;
  vec4 plain = textureLod(styled, at, 0.0);
  bool away = plain.a < 0.5 || is_cut_away(in_fruit, knife_number);
  if (away) discard;
  vec3 color = plain.rgb;
  if (!away) color = shown(at, dx, dy, footprint);  // as in skin.glsl
  pixel = vec4(srgb_from_linear(color), 1.0);
}
#endif
#endif

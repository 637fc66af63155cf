// How a surface is lit.
#include "material.glsl"

uniform vec3 to_light;  // unit, scene
uniform float gloss;
uniform vec2 light_strengths;  // of the light, of the ambient light

#ifdef WINDOW
#include "window.glsl"
const vec3 sun = vec3(1.02, 0.96, 0.86);
const vec3 sky = vec3(0.36, 0.39, 0.43);
const vec3 bounce = vec3(0.30, 0.275, 0.235);
#else
const vec3 sun = vec3(0.74, 0.70, 0.62);
const vec3 sky = vec3(0.47, 0.50, 0.54);
const vec3 bounce = vec3(0.40, 0.36, 0.31);
#endif
const float film_frequency = 95.0;  // of the waves of a film of juice, cycles per metre

// The light at a place: how much of the sky and of the sun reaches it, and for each colour the share of the sunlight
// that arrives through the fruit, and that would leave the fruit behind the place.
struct Seen {
  float sky, sun;
  vec3 arrives, leaves;
};

// Sunlight on a face, soft and wrapped.
float wrapped(float cosine) { return clamp((cosine + 0.35) / 1.35, 0.0, 1.0); }

// The share of the light that enters deeply where a part lets light in.
float let_in(float depth) { return 0.85 * depth / (depth + 0.001); }

vec3 sky_at(float up, float seen) {
  return light_strengths.y * mix(bounce, sky, 0.5 + 0.5 * up) * mix(0.2, 1.0, seen);
}

#ifdef WINDOW
// A large light, less wrapped than a drawing's. Most of the light that leaves a piece through its face comes back from
// the table, so that thin slices are as bright as thick ones; light from behind has passed through the colour once
// more.
vec3 dull_color(vec3 color, vec3 n, Seen seen, bool cut, float depth) {
  float towards = dot(n, to_light), key = clamp((towards + 0.22) / 1.22, 0.0, 1.0);
  if (cut) key = mix(key, 0.82, 0.3);
  float lit = key * mix(0.03, 1.0, seen.sun) * mix(0.75, 1.0, seen.sky);
  float beyond = clamp((0.35 - towards) / 1.35, 0.0, 1.0);
  vec3 within = 1.15 * let_in(depth) * seen.arrives * beyond * mix(0.6, 1.0, seen.sky);
  vec3 direct = lit * (1.0 - 0.3 * let_in(depth) * seen.leaves) + within;
  vec3 open_sky = mix(vec3(0.1), vec3(1.0), with_bounces(seen.sky, color));
  vec3 around = light_strengths.y * mix(bounce, sky, 0.5 + 0.5 * n.y) * open_sky;
  vec3 received = around + light_strengths.x * sun * direct;
  float shade = clamp(1.0 - dot(received, vec3(0.33)), 0.0, 1.0);
  return pow(max(color, 1e-4), vec3(1.0 + 0.34 * shade)) * received;
}
#else
vec3 dull_color(vec3 color, vec3 n, Seen seen, bool cut, float depth) {
  // Even flatter on cut faces, so that their colours dominate.
  float key = wrapped(dot(n, to_light));
  if (cut) key = mix(key, 0.8, 0.45);
  float open_sky = mix(0.7, 1.0, seen.sky);
  float lit = key * mix(0.12, 1.0, seen.sun) * open_sky;

  // Transmitted light is removed where it enters and added where it leaves, minus the wrapped light that is already
  // there, and minus a tenth that is absorbed.
  float beyond = max(wrapped(-dot(n, to_light)) - wrapped(dot(n, to_light)), 0.0);
  vec3 within = 0.9 * let_in(depth) * seen.arrives * beyond * open_sky;
  // Where a piece lies on its skin, what leaves through it comes back from the table: a cap's face is as bright as a
  // half's, and no bowl.
  vec3 lost = let_in(depth) * seen.leaves * (cut ? 0.3 : 1.0);
  vec3 direct = lit * (1.0 - lost) + within;
  vec3 received = sky_at(n.y, seen.sky) + light_strengths.x * sun * direct;

  // In the shade colours become deeper, not greyer.
  float shade = clamp(1.0 - dot(received, vec3(0.33)), 0.0, 1.0);
  return pow(max(color, 1e-4), vec3(1.0 + 0.22 * shade)) * received;
}

#endif

vec3 dull_color(vec3 color, vec3 n, vec2 seen, bool cut) {
  return dull_color(color, n, Seen(seen.x, seen.y, vec3(0.0), vec3(0.0)), cut, 0.0);
}

// The light as a window with two bars, as a smooth skin reflects it.
float window(vec3 n, vec3 to_eye, float roughness) {
  vec3 seen = reflect(-to_eye, n);
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), to_light) + vec3(1e-5, 0.0, 0.0)), up = cross(to_light, right);
  vec2 at = vec2(dot(seen, right), dot(seen, up));
  float soft = 0.04 + 0.5 * roughness;
  vec2 pane = smoothstep(-soft, soft, vec2(0.15, 0.21) - abs(at));
  vec2 bar = 1.0 - 0.55 * exp(-(at * at) / (0.0009 + 0.25 * soft * soft)) * clamp(1.4 - 10.0 * roughness, 0.0, 1.0);
  return dot(seen, to_light) > 0.0 ? pane.x * pane.y * bar.x * bar.y : 0.0;
}

// A skin of ordinary roughness shines a little, a smooth one shows a window, a rough one a wide sheen.
float skin_shine(vec3 n, vec3 to_eye, float roughness) {
  float spot = max(dot(n, normalize(to_light + to_eye)), 0.0);
  float sharp = 6.3 / (roughness * roughness);
  float smooth_skin = smoothstep(0.28, 0.14, roughness);
  float lobes = 0.16 * min(0.3 / roughness, 1.6) * pow(spot, sharp) + 0.07 * pow(spot, 0.2 * sharp);
  return mix(lobes, 0.06 * pow(spot, 14.0) + 0.42 * window(n, to_eye, roughness), smooth_skin);
}

// A film of juice is not flat: it has waves of some millimetres. A wet face shows a broad sheen, and a few highlights
// of some millimetres where the film leans towards the light's mirror direction. A slightly wet face shows only a
// little sheen and no highlights. The film's slope is noise at the place in the fruit.
float cut_shine(vec3 n, vec3 to_eye, float wet, vec3 position, float footprint) {
  vec3 half_way = normalize(to_light + to_eye);
  float film = smoothstep(0.3, 1.2, wet) * (1.0 - smoothstep(0.25, 0.5, film_frequency * footprint));
  float sheen = 0.02 * min(wet, 2.0) * pow(max(dot(n, half_way), 0.0), 24.0);
  if (film <= 0.0 || dot(n, half_way) < 0.5) return sheen;
  vec3 q = position * film_frequency;
  vec3 swell = vec3(0.0);
  int axis = 0, axes = film > 0.0 ? 3 : 1;  // one where the branch above has been taken (README.md)
  do swell[axis] = gradient_noise(q + (axis == 0 ? 0.0 : axis == 1 ? 17.3 : -9.1), 411u + uint(axis));
  while (++axis < axes);
  float mirror = dot(normalize(n + 0.6 * swell), half_way);
  float bright = 0.025 * smoothstep(0.93, 0.995, mirror) + 0.17 * smoothstep(0.990, 0.998, mirror);
  return sheen + film * (0.6 + 0.25 * min(wet, 2.4)) * bright;
}

#ifdef WINDOW
// A wet face: its film of juice has waves of a centimetre and of some millimetres. It reflects the window in a few
// patches with the window's shape, and elsewhere a little of the room.
vec3 wet_gleam(vec3 n, vec3 to_eye, float wet, vec3 position, float footprint, Seen seen) {
  float film = smoothstep(0.25, 1.2, wet);
  if (film <= 0.0) return vec3(0.0);
  vec3 slope = vec3(0.0);
  int k = 0;
  do {
    float cycles = k < 3 ? 75.0 : 260.0;
    float shown = 1.0 - smoothstep(0.2, 0.45, cycles * footprint);
    float height = (k < 3 ? 0.24 : 0.11) * shown;
    if (shown > 0.0) slope[k % 3] += height * gradient_noise(position * cycles + float(k % 3) * 17.3, 431u + uint(k));
  } while (++k < 6);
  vec3 m = normalize(n + slope);
  vec3 mirrored = reflect(-to_eye, m);
  float share = of_water(dot(m, to_eye)) * film * mix(0.6, 1.0, smoothstep(0.5, 2.2, wet));
  float pane = window(m, to_eye, 0.10) * mix(0.1, 1.0, seen.sun);
  pane += 0.45 * high_window(mirrored, to_light) * seen.sky * seen.sky;
  vec3 bright = 20.0 * light_strengths.x * pane * vec3(1.0, 0.98, 0.95);
  return share * (room_at(mirrored, to_light) * mix(0.25, 1.0, seen.sky) + bright);
}
#endif

// How much a part is a gel: light enters deeply, and it is wet.
float gel_of(Material m) { return smoothstep(0.0034, 0.0055, m.depth) * smoothstep(1.0, 2.2, m.wet); }

// A gel shows its depth: near its walls, light returns from them through little gel, which makes a pale halo; farther
// in, the gel deepens by its transmitted colour [Beer-Lambert]. `rim`: millimetres to the wall.
vec3 gel_color(vec3 color, Material m, float rim) {
  float gel = gel_of(m);
  if (gel <= 0.0) return color;
  vec3 through = m.inner_color / max(max(m.inner_color.r, m.inner_color.g), m.inner_color.b);
  float way = 2.0 * min(rim, 3.5);
  vec3 deep = color * pow(max(through, 0.05), vec3(way / 8.0)) * exp(-way / 22.0);
  vec3 halo = mix(color, min(1.25 * color + 0.12 * through, 1.0), 0.75);
  return mix(color, mix(deep, halo, exp(-rim * rim / 0.4)), gel);
}

float shine(vec3 n, vec3 to_eye, bool cut) {
  return cut ? 0.035 * pow(max(dot(n, normalize(to_light + to_eye)), 0.0), 24.0) : skin_shine(n, to_eye, 0.3);
}

// `position`: in the fruit, metres; a pixel covers `footprint` metres of it.
// `rim`: of a cut face's part, millimetres to its border.
vec3 fruit_color(vec3 color, vec3 n, vec3 to_eye, Seen seen, bool cut, Material m, vec3 position, float footprint,
                 float rim) {
  float cosine = clamp(dot(n, to_eye), 0.0, 1.0);
  float veil = cut ? 0.0 : bloom_cover(m, position, cosine);
  color = mix(color, m.bloom.rgb, veil);
  if (cut) color = gel_color(color, m, rim);
  vec3 dull = dull_color(color, n, seen, cut, m.depth);
  float aslant = 1.0 - cosine;
  float slant = aslant * aslant * aslant * aslant * aslant;
#ifdef WINDOW
  if (cut) return dull + gloss * wet_gleam(n, to_eye, m.wet, position, footprint, seen);
  float smooth_skin = smoothstep(0.5, 0.12, m.roughness);
  vec3 mirrored = room_at(reflect(-to_eye, n), to_light) * mix(0.2, 1.0, seen.sky) * of_water(cosine) * smooth_skin;
#endif
  if (cut) {
    // Water reflects a little of the sky, most at grazing angles.
    vec3 sky_in_film = sky_at(reflect(-to_eye, n).y, seen.sky) * (0.008 + 0.4 * slant) * min(m.wet, 2.0);
    return dull + gloss * (cut_shine(n, to_eye, m.wet, position, footprint) * seen.sun * vec3(1.0, 0.98, 0.94) +
                           sky_in_film);
  }

  // Hairs too fine to be drawn are most visible along the rim, where they overlap.
  float hairs = m.fuzz.a * aslant * aslant * aslant;
  float on_side = mix(0.3, 1.0, seen.sun) * wrapped(dot(n, to_light) + 0.35);
  vec3 on_hairs = sky_at(0.4 + 0.5 * n.y, seen.sky) + light_strengths.x * sun * on_side;
  dull = mix(dull, 1.1 * m.fuzz.rgb * on_hairs, hairs);

  // At grazing angles even a dull skin reflects the sky.
  vec3 reflected = sky_at(reflect(-to_eye, n).y, seen.sky) * slant * 0.5 * smoothstep(0.5, 0.1, m.roughness);
  float polish = gloss * m.gloss * (1.0 - 0.8 * veil) * (1.0 - m.fuzz.a);
#ifdef WINDOW
  reflected = mirrored;
#endif
  return dull + polish * (skin_shine(n, to_eye, m.roughness) * seen.sun * vec3(1.0, 0.98, 0.94) + reflected);
}

// Texture detail along a fruit's surfaces: the mirror of render/style/detail.cpp and look.cpp.
#include "noise.glsl"

// Every solid's details, four of its cut faces and four of its skin (render/gl/detail_texels.h): kind, run, amount,
// whether it has a colour; size, length, width, density; softness, wander, variety, near_within or 0; OKLab target,
// smallest; OKLab near, pitch; threshold, ramp, mean share, mean tone; reach, middle, seed, relief. Examples have
// instead: size, length, the tile's side, its first texel; highest colour, near_within or 0; mean colour, aside.x; OKLab
// near, aside.y; lowest colour, aside.z. Tiles follow, level after level: linear colour, share.
uniform samplerBuffer detail_styles;
const int detail_texels = 7;
const int details_of_a_face = 4;

const int no_detail = -1, fibres = 0, cells = 1, speckles = 2, streaks = 3, net = 4, example = 5;
const int runs_nowhere = 0, runs_to_skin = 1, runs_along = 2, runs_around = 3;

uint lattice_hash(ivec3 cell, uint seed) {
  return mixed_bits((uint(cell.x) * 0x8da6b343u) ^ (uint(cell.y) * 0xd8163841u) ^ (uint(cell.z) * 0xcb1ab31fu) ^
                    (seed * 0x9e3779b9u));
}

vec3 tens_of_bits(uint hash) { return vec3(hash & 1023u, (hash >> 10) & 1023u, (hash >> 20) & 1023u); }
float share_of(uint hash) { return float(hash >> 8) / 16777216.0; }

// Distances to the nearest and second nearest feature point, and the random share of the nearest one's cell; undefined
// where nothing `counts`.
vec3 cell_place(vec3 point, uint seed, bool counts) {
  vec3 low = floor(point), within = point - low;
  float nearest = 8.0, second = 8.0;
  uint own = 0u;
  int i = counts ? 0 : 26;
  do {
    ivec3 beside = ivec3(i % 3, (i / 3) % 3, i / 9) - 1;
    uint hash = lattice_hash(ivec3(low) + beside, seed);
    vec3 away = vec3(beside) + tens_of_bits(hash) * (0.9 / 1023.0) + 0.05 - within;
    float squared = dot(away, away);
    second = min(second, max(nearest, squared));
    own = squared < nearest ? hash : own;
    nearest = min(nearest, squared);
  } while (++i < 27);
  return vec3(sqrt(nearest), sqrt(second), share_of(own));
}

float dots(vec3 point, float pitch, float density, float smallest, float softness, uint seed) {
  vec3 low = floor(point);
  uint hash = lattice_hash(ivec3(low), seed);
  float chance = share_of(lattice_hash(ivec3(int(hash & 0x7fffffffu), 1, 0), seed));
  if (chance >= density) return 0.0;
  float widest = 0.5 * pitch;
  float radius = mix(widest * smallest, widest, chance / density);
  vec3 away = point - low - radius - tens_of_bits(hash) * ((1.0 - 2.0 * radius) / 1023.0);
  return 1.0 - smoothstep(0.9 * (1.0 - softness), 1.0, length(away) / radius);
}

// A place in the pattern; w: how much finer the pattern is here than its size.
vec4 pattern_place(int run, vec4 sizes, vec2 fruit, vec3 position, vec4 way_layer) {
  if (run == runs_nowhere) return vec4(position / sizes.x, 1.0);
  float radius = max(length(position.xz), 1e-9);
  vec3 foot = position + way_layer.xyz;
  float foot_radius = length(foot.xz);
  if (run == runs_to_skin) {
    return vec4(position / sizes.x + way_layer.xyz * (1.0 / sizes.x - 1.0 / sizes.y), max(1.0, foot_radius / radius));
  }
  vec2 azimuth = position.xz / radius;
  float height = foot.y - fruit.y;
  float up = height + clamp(height / fruit.y, -1.0, 1.0) * (fruit.x - foot_radius);
  if (run == runs_around) {
    float circle = fruit.x / sizes.y;
    return vec4(way_layer.w / sizes.x + circle * azimuth.x, up / sizes.x, circle * azimuth.y, 1.0);
  }
  float outwards = fruit.x - way_layer.w;
  return vec4(outwards / sizes.x * azimuth.x, up / sizes.y, outwards / sizes.x * azimuth.y,
              max(1.0, abs(outwards) / radius));
}

// Noise at its own size, half as strong at half of that where `fine`, and for streaks at four times its size.
float line_noise(vec3 p, float fine, uint seed, int octaves) {
  float sum = 0.0;
  int i = 0;
  do {
    float amount = i == 0 ? 1.0 : i == 1 ? 0.5 * fine : 0.6;
    float scale = i == 0 ? 1.0 : i == 1 ? 2.0 : 0.23, aside = i == 0 ? 0.0 : i == 1 ? 3.1 : 5.7;
    sum += amount * gradient_noise(scale * p + aside, seed + (i == 0 ? 0u : uint(i + 2)));
  } while (++i < octaves);
  return sum;
}

// The pattern's share and tone; `fine`: how much of the finer structure is shown. The bounds of loops are their numbers
// of turns if their branch is taken; if it is not, software renderers run them once.
vec2 pattern_at(int detail, int kind, vec3 p, float fine) {
  vec4 sizes = texelFetch(detail_styles, detail + 1), form = texelFetch(detail_styles, detail + 2);
  vec4 line = texelFetch(detail_styles, detail + 5);
  float pitch = texelFetch(detail_styles, detail + 4).w;
  uint seed = uint(texelFetch(detail_styles, detail + 6).z);
  p = vec3(2.0 * p.x - p.y + 2.0 * p.z, 2.0 * p.x + 2.0 * p.y - p.z, 2.0 * p.y + 2.0 * p.z - p.x) / 3.0 + 0.37;
  if (form.y > 0.0) {
    vec2 swirl = vec2(0.0);
    int i = 0, ways = form.y > 0.0 ? 2 : 1;
    do swirl[i] = gradient_noise(p * 0.45 + 7.3 * float(i), seed + 1u + uint(i));
    while (++i < ways);
    p += 1.6 * form.y * vec3(swirl, -swirl.x);
  }
  if (kind == fibres || kind == streaks) {
    float noise = line_noise(p, fine, seed, kind == streaks ? 3 : fine > 0.0 ? 2 : 1);
    return vec2(smoothstep(line.x - line.y, line.x + line.y, noise), 0.0);
  }
  if (kind == speckles) {
    float smallest = texelFetch(detail_styles, detail + 3).w / sizes.x;
    return vec2(max(dots(pitch * p, pitch, sizes.w, smallest, form.x, seed),
                    dots(pitch * p + 0.5, pitch, sizes.w, smallest, form.x, seed + 5u)), 0.0);
  }
  vec3 cell = cell_place(p, seed, kind == cells || kind == net);
  float border = cell.y - cell.x, rim = 0.3 * sizes.z;
  if (kind == cells) {
    float border_line = 1.0 - smoothstep(rim, rim + 0.05 + 0.45 * form.x, border);
    return vec2(border_line, 2.0 * form.z * (cell.z - 0.5) * (1.0 - border_line));
  }
  float soft = 0.04 + 0.25 * form.x;
  float risen = smoothstep(rim, rim + soft, border);
  return vec2(1.0 - risen, -form.z * risen * (1.0 - smoothstep(rim + soft, rim + 3.0 * soft, border)));
}

#ifdef EXAMPLES
// A tile's colour and share at a place, periodic in whole numbers, trilinear (render/style/example.cpp).
vec4 level_color(vec3 place, int side, int first) {
  vec3 texel = fract(place) * float(side) - 0.5, low = floor(texel), t = texel - low;
  ivec3 n = (ivec3(low) + side) % side;
  vec4 sum = vec4(0.0);
  int i = 0;
  do {
    ivec3 beside = ivec3(i & 1, (i >> 1) & 1, i >> 2), at = (n + beside) % side;
    vec3 weight = mix(1.0 - t, t, vec3(beside));
    int number = first + (at.z * side + at.y) * side + at.x;
    sum += weight.x * weight.y * weight.z * texelFetch(detail_styles, number);
  } while (++i < 8);
  return sum;
}

// What an example shows at a place of the fruit.
vec4 example_color(int detail, vec3 position, float footprint, vec4 way_layer) {
  vec4 sizes = texelFetch(detail_styles, detail + 1);
  vec4 place = pattern_place(int(texelFetch(detail_styles, detail).y), sizes, texelFetch(detail_styles, detail + 6).xy,
                             position, way_layer);
  vec3 aside = vec3(texelFetch(detail_styles, detail + 3).w, texelFetch(detail_styles, detail + 4).w,
                    texelFetch(detail_styles, detail + 5).w);
  vec3 q = place.xyz * mat3(0.68575450, -0.49219656, 0.53617471, 0.72195463, 0.36655826, -0.58687014, 0.09231620,
                            0.78954265, 0.60671256) + aside;
  float texels = footprint * place.w / sizes.x * sizes.z;
  int side = int(sizes.z), first = int(sizes.w);
  while (texels >= 2.0 && side > 1) {
    first += side * side * side;
    side = (side & 1) == 0 ? side / 2 : 1;
    texels *= 0.5;
  }
  vec4 color = level_color(q, side, first);
  float coarser = side > 1 ? clamp(texels - 1.0, 0.0, 1.0) : 0.0;
  int next = (side & 1) == 0 ? side / 2 : 1;
  return coarser > 0.0 ? mix(color, level_color(q, next, first + side * side * side), coarser) : color;
}

// A colour with what an example shows, which leaves the mean and clips nothing.
vec3 with_example(int detail, vec3 color, vec3 shown, float weight) {
  vec3 mean = texelFetch(detail_styles, detail + 3).xyz;
  vec3 below = weight * (mean - texelFetch(detail_styles, detail + 5).xyz);
  vec3 above = weight * (texelFetch(detail_styles, detail + 2).xyz - mean);
  vec3 room = min(vec3(1.0), min(max(color, 0.0) / max(below, 1e-6), max(1.0 - color, 0.0) / max(above, 1e-6)));
  return color + room * weight * (shown - mean);
}
#endif

// A detail's pattern at a place of the fruit, faded if it is too fine for the picture. `kind`: the detail's.
vec2 shown_pattern(int detail, int kind, vec3 position, float footprint, vec4 way_layer) {
#ifdef EXAMPLES
  if (kind == example) return vec2(example_color(detail, position, footprint, way_layer).a, 0.0);
#endif
  vec4 sizes = texelFetch(detail_styles, detail + 1);
  vec4 place = pattern_place(int(texelFetch(detail_styles, detail).y), sizes, texelFetch(detail_styles, detail + 6).xy,
                             position, way_layer);
  float cycles = footprint * place.w / sizes.x;
  vec2 here = pattern_at(detail, kind, place.xyz, 1.0 - smoothstep(0.125, 0.25, cycles));
  return mix(texelFetch(detail_styles, detail + 5).zw, here, 1.0 - smoothstep(0.25, 0.5, cycles));
}

// The direction to the skin and the layer at a neighbouring place (render/style/relief.cpp).
vec4 guide_beside(vec4 way_layer, vec3 step_away) {
  float way = length(way_layer.xyz);
  if (way < 1e-6) return way_layer;
  float nearer = dot(step_away, way_layer.xyz) / way;
  return vec4(way_layer.xyz * (1.0 - nearer / way), way_layer.w - nearer);
}

#ifdef EXAMPLES
// A modulated colour with a solid's examples (the mirror of Look::with_examples in render/style/look.cpp).
vec3 with_examples(vec3 color, vec3 plain, vec3 position, float footprint, int of_face, vec4 way_layer, vec4 share) {
  int i = 0;
  do {
    int detail = of_face + detail_texels * i;
    vec4 head = texelFetch(detail_styles, detail);
    float within = texelFetch(detail_styles, detail + 2).w;
    vec3 d = plain - texelFetch(detail_styles, detail + 4).xyz;
    float weight = head.z * share[i] * (within > 0.0 ? exp(-dot(d, d) / (2.0 * within * within)) : 1.0);
    if (int(head.x) == example && weight >= 1e-3) {
      color = with_example(detail, color, example_color(detail, position, footprint, way_layer).rgb, weight);
    }
  } while (++i < details_of_a_face);
  return color;
}
#endif

struct Detailed {
  vec3 color, normal;
};

// A modulated colour with a solid's details, and the scene's normal tilted by the slope of their height in metres (the
// mirror of Look::height in render/style/look.cpp). Weights depend on the colour before its modulation. The columns of
// `to_fruit` are the scene's directions in the fruit.
Detailed detailed(vec3 color, vec3 normal, vec3 unmodulated, mat3 to_fruit, vec3 position, float footprint, int solid,
                  bool cut, vec4 way_layer, vec4 share) {
  vec3 plain = to_oklab(unmodulated), lab = to_oklab(color);
  vec3 first = normalize(cross(abs(normal.y) < 0.8 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), normal));
  vec3 second = cross(normal, first);
  float by = max(0.5 * footprint, 1e-5);
  vec3 height = vec3(0.0);  // here, and one step away along each axis
  bool changed = false, risen = false;

  int of_face = detail_texels * details_of_a_face * (2 * solid + (cut ? 0 : 1)), i = 0;
#ifdef EXAMPLES
  color = with_examples(color, plain, position, footprint, of_face, way_layer, share);
  lab = to_oklab(color);
#endif
  do {
    int detail = of_face + detail_texels * i;
    vec4 head = texelFetch(detail_styles, detail);
    float relief = texelFetch(detail_styles, detail + 6).w * share[i], weight = head.z * share[i];
    float within = texelFetch(detail_styles, detail + 2).w;
    vec3 d = plain - texelFetch(detail_styles, detail + 4).xyz;
    float likeness = within > 0.0 ? exp(-dot(d, d) / (2.0 * within * within)) : 1.0;
    risen = risen || relief != 0.0;
    relief *= likeness;
    weight *= likeness;
#ifdef EXAMPLES
    if (int(head.x) == example) weight = 0.0;
#endif

    int places = relief != 0.0 ? 3 : 1, k = 0;
    do {
      vec3 step_away = to_fruit * (k == 0 ? vec3(0.0) : by * (k == 1 ? first : second));
      vec2 value = shown_pattern(detail, int(head.x), position + step_away, footprint, guide_beside(way_layer, step_away));
      height[k] += relief != 0.0 ? relief * value.x : 0.0;
      if (k == 0 && abs(weight) >= 1e-3) {
        vec3 target = texelFetch(detail_styles, detail + 3).xyz;
        lab += value.x * weight * (head.w > 0.0 ? target - lab : target);
        lab.x += value.y * abs(weight) * 0.12;
        changed = true;
      }
    } while (++k < places);
  } while (++i < details_of_a_face && int(texelFetch(detail_styles, of_face + detail_texels * i).x) != no_detail);

  if (changed) color = clamp(from_oklab(lab), 0.0, 1.0);
  if (risen) normal = normalize(normal - ((height.y - height.x) * first + (height.z - height.x) * second) / by);
  return Detailed(color, normal);
}

// Texture detail along a fruit's surfaces: the mirror of render/style/detail.cpp and look.cpp.
#include "noise.glsl"

// Every solid's details, four of its cut faces and four of its skin (render/gl/detail_texels.h): kind, run, amount,
// whether it has a colour; size, length, width, density; softness, wander, variety, near_within or 0; OKLab target,
// smallest; OKLab near, pitch; threshold, ramp, mean share, mean tone; reach, middle, seed, relief.
uniform samplerBuffer detail_styles;
const int detail_texels = 7;
const int details_of_a_face = 4;

const int no_detail = -1, fibres = 0, cells = 1, speckles = 2, streaks = 3, net = 4;
const int runs_nowhere = 0, runs_to_skin = 1, runs_along = 2, runs_around = 3;

uint lattice_hash(ivec3 cell, uint seed) {
  return mixed_bits((uint(cell.x) * 0x8da6b343u) ^ (uint(cell.y) * 0xd8163841u) ^ (uint(cell.z) * 0xcb1ab31fu) ^
                    (seed * 0x9e3779b9u));
}

vec3 tens_of_bits(uint hash) { return vec3(hash & 1023u, (hash >> 10) & 1023u, (hash >> 20) & 1023u); }
float share_of(uint hash) { return float(hash >> 8) / 16777216.0; }

// Distances to the nearest and second nearest feature point, and the nearest one's cell's own share.
vec3 cell_place(vec3 point, uint seed) {
  vec3 low = floor(point), within = point - low;
  float nearest = 8.0, second = 8.0;
  uint own = 0u;
  for (int i = 0; i < 27; ++i) {
    ivec3 beside = ivec3(i % 3, (i / 3) % 3, i / 9) - 1;
    uint hash = lattice_hash(ivec3(low) + beside, seed);
    vec3 away = vec3(beside) + tens_of_bits(hash) * (0.9 / 1023.0) + 0.05 - within;
    float squared = dot(away, away);
    second = min(second, max(nearest, squared));
    own = squared < nearest ? hash : own;
    nearest = min(nearest, squared);
  }
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

// A place in the pattern; w: how much finer it is here than its size says.
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

// The pattern's share and tone; `fine`: how much of what is finer than the size is shown.
vec2 pattern_at(int detail, int kind, vec3 p, float fine) {
  vec4 sizes = texelFetch(detail_styles, detail + 1), form = texelFetch(detail_styles, detail + 2);
  vec4 line = texelFetch(detail_styles, detail + 5);
  float pitch = texelFetch(detail_styles, detail + 4).w;
  uint seed = uint(texelFetch(detail_styles, detail + 6).z);
  p = vec3(2.0 * p.x - p.y + 2.0 * p.z, 2.0 * p.x + 2.0 * p.y - p.z, 2.0 * p.y + 2.0 * p.z - p.x) / 3.0 + 0.37;
  if (form.y > 0.0) {
    float a = gradient_noise(p * 0.45, seed + 1u), b = gradient_noise(p * 0.45 + 7.3, seed + 2u);
    p += 1.6 * form.y * vec3(a, b, -a);
  }
  if (kind == fibres || kind == streaks) {
    float noise = gradient_noise(p, seed);
    if (fine > 0.0) noise += 0.5 * fine * gradient_noise(2.0 * p + 3.1, seed + 3u);
    if (kind == streaks) noise += 0.6 * gradient_noise(0.23 * p + 5.7, seed + 4u);
    return vec2(smoothstep(line.x - line.y, line.x + line.y, noise), 0.0);
  }
  if (kind == speckles) {
    float smallest = texelFetch(detail_styles, detail + 3).w / sizes.x;
    return vec2(max(dots(pitch * p, pitch, sizes.w, smallest, form.x, seed),
                    dots(pitch * p + 0.5, pitch, sizes.w, smallest, form.x, seed + 5u)), 0.0);
  }
  vec3 cell = cell_place(p, seed);
  float border = cell.y - cell.x, rim = 0.3 * sizes.z;
  if (kind == cells) {
    float border_line = 1.0 - smoothstep(rim, rim + 0.05 + 0.45 * form.x, border);
    return vec2(border_line, 2.0 * form.z * (cell.z - 0.5) * (1.0 - border_line));
  }
  float soft = 0.04 + 0.25 * form.x;
  float risen = smoothstep(rim, rim + soft, border);
  return vec2(1.0 - risen, -form.z * risen * (1.0 - smoothstep(rim + soft, rim + 3.0 * soft, border)));
}

// A modulated colour with a solid's details on it; weights go by the colour before its modulation.
vec3 detailed(vec3 color, vec3 unmodulated, vec3 position, float footprint, int solid, bool cut, vec4 way_layer,
              vec4 share) {
  if (share == vec4(0.0)) return color;
  vec3 plain = to_oklab(unmodulated), lab = to_oklab(color);
  bool changed = false;
  for (int i = 0; i < details_of_a_face; ++i) {
    int detail = detail_texels * (details_of_a_face * (2 * solid + (cut ? 0 : 1)) + i);
    vec4 head = texelFetch(detail_styles, detail);
    float weight = head.z * share[i];
    if (int(head.x) == no_detail || abs(weight) < 1e-3) continue;
    float within = texelFetch(detail_styles, detail + 2).w;
    vec3 d = plain - texelFetch(detail_styles, detail + 4).xyz;
    if (within > 0.0) weight *= exp(-dot(d, d) / (2.0 * within * within));
    if (abs(weight) < 1e-3) continue;

    vec4 sizes = texelFetch(detail_styles, detail + 1);
    vec4 place = pattern_place(int(head.y), sizes, texelFetch(detail_styles, detail + 6).xy, position, way_layer);
    float cycles = footprint * place.w / sizes.x;
    float shown = 1.0 - smoothstep(0.25, 0.5, cycles);
    vec2 value = texelFetch(detail_styles, detail + 5).zw;
    if (shown > 0.0) {
      vec2 here = pattern_at(detail, int(head.x), place.xyz, 1.0 - smoothstep(0.125, 0.25, cycles));
      value = mix(value, here, shown);
    }
    vec3 target = texelFetch(detail_styles, detail + 3).xyz;
    lab += value.x * weight * (head.w > 0.0 ? target - lab : target);
    lab.x += value.y * abs(weight) * 0.12;
    changed = true;
  }
  return changed ? clamp(from_oklab(lab), 0.0, 1.0) : color;
}

// How high a solid's details stand out, metres: the mirror of Look::height in render/style/look.cpp. `plain`: OKLab of the
// colour before its modulation.
float detail_height(vec3 plain, vec3 position, float footprint, int solid, bool cut, vec4 way_layer, vec4 share) {
  float sum = 0.0;
  for (int i = 0; i < details_of_a_face; ++i) {
    int detail = detail_texels * (details_of_a_face * (2 * solid + (cut ? 0 : 1)) + i);
    vec4 head = texelFetch(detail_styles, detail), last = texelFetch(detail_styles, detail + 6);
    float relief = last.w * share[i];
    if (int(head.x) == no_detail || relief == 0.0) continue;
    float within = texelFetch(detail_styles, detail + 2).w;
    vec3 d = plain - texelFetch(detail_styles, detail + 4).xyz;
    if (within > 0.0) relief *= exp(-dot(d, d) / (2.0 * within * within));

    vec4 sizes = texelFetch(detail_styles, detail + 1);
    vec4 place = pattern_place(int(head.y), sizes, last.xy, position, way_layer);
    float cycles = footprint * place.w / sizes.x;
    float shown = 1.0 - smoothstep(0.25, 0.5, cycles);
    float value = texelFetch(detail_styles, detail + 5).z;
    if (shown > 0.0)
      value = mix(value, pattern_at(detail, int(head.x), place.xyz, 1.0 - smoothstep(0.125, 0.25, cycles)).x, shown);
    sum += relief * value;
  }
  return sum;
}

// The way to the skin and the layer at a place beside (render/style/relief.cpp).
vec4 guide_beside(vec4 way_layer, vec3 step_away) {
  float way = length(way_layer.xyz);
  if (way < 1e-6) return way_layer;
  float nearer = dot(step_away, way_layer.xyz) / way;
  return vec4(way_layer.xyz * (1.0 - nearer / way), way_layer.w - nearer);
}

// Whether any detail of such faces has a relief and counts here.
bool any_relief(int solid, bool cut, vec4 share) {
  vec4 relief = vec4(0.0);
  for (int i = 0; i < details_of_a_face; ++i) {
    int detail = detail_texels * (details_of_a_face * (2 * solid + (cut ? 0 : 1)) + i);
    relief[i] = texelFetch(detail_styles, detail + 6).w;
  }
  return relief * share != vec4(0.0);
}

// A scene's normal, tilted by the slope of the details' height. The columns of `to_fruit` are the scene's directions in the
// fruit.
vec3 detail_normal(vec3 normal, mat3 to_fruit, vec3 unmodulated, vec3 position, float footprint, int solid, bool cut,
                   vec4 way_layer, vec4 share) {
  if (share == vec4(0.0) || !any_relief(solid, cut, share)) return normal;
  vec3 plain = to_oklab(unmodulated);
  float by = max(0.5 * footprint, 1e-5);
  vec3 first = normalize(cross(abs(normal.y) < 0.8 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), normal));
  vec3 second = cross(normal, first);
  vec3 steps[3] = vec3[3](vec3(0.0), by * first, by * second);
  float height[3];
  for (int i = 0; i < 3; ++i) {
    vec3 step_away = to_fruit * steps[i];
    height[i] = detail_height(plain, position + step_away, footprint, solid, cut, guide_beside(way_layer, step_away), share);
  }
  return normalize(normal - ((height[1] - height[0]) * first + (height[2] - height[0]) * second) / by);
}

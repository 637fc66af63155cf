// Gradient noise [Perlin 2002] and the modulation of colours: the mirror of render/style/noise.cpp.
#include "color.glsl"

// Every solid's style, noise_texels each (render/gl/scene_upload.cpp): base frequency, sigma, keys, bands; stretch
// along radius, height, azimuth, and the pattern; then for each key its OKLab colour, its axis, and weights of bands
// 0-3 and 4-7.
uniform samplerBuffer noise_styles;
const int noise_texels = 66;

uint mixed_bits(uint h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ (h >> 16);
}

float corner_noise(ivec3 cell, uint seed, vec3 p) {
  uint h = mixed_bits((uint(cell.x) * 0x8da6b343u) ^ (uint(cell.y) * 0xd8163841u) ^ (uint(cell.z) * 0xcb1ab31fu) ^
                      (seed * 0x9e3779b9u)) & 15u;
  float u = h < 8u ? p.x : p.y;
  float v = h < 4u ? p.y : (h == 12u || h == 14u) ? p.x : p.z;
  return ((h & 1u) != 0u ? -u : u) + ((h & 2u) != 0u ? -v : v);
}

// `mask`: which bits of z count; ~0 unless the lattice closes around an axis.
#ifdef COMPACT
// A loop, because software renderers compile inlined copies for minutes.
float lattice_noise(vec3 point, uint seed, int mask) {
  vec3 low = floor(point), p = point - low;
  vec3 t = p * p * p * (p * (p * 6.0 - 15.0) + 10.0);
  float sum = 0.0;
  int k = 0;
  do {
    ivec3 aside = ivec3(k & 1, k >> 1 & 1, k >> 2), cell = ivec3(low) + aside;
    cell.z &= mask;
    vec3 share = mix(1.0 - t, t, vec3(aside));
    sum += share.x * share.y * share.z * corner_noise(cell, seed, p - vec3(aside));
  } while (++k < 8);
  return clamp(sum, -1.0, 1.0);
}
#else
float lattice_noise(vec3 point, uint seed, int mask) {
  vec3 low = floor(point);
  ivec3 i = ivec3(low);
  vec3 p = point - low;
  vec3 t = p * p * p * (p * (p * 6.0 - 15.0) + 10.0);
  ivec3 j = i + 1;
  i.z &= mask;
  j.z &= mask;
  vec3 q = p - 1.0;
  float near = mix(mix(corner_noise(i, seed, p), corner_noise(ivec3(j.x, i.yz), seed, vec3(q.x, p.yz)), t.x),
                   mix(corner_noise(ivec3(i.x, j.y, i.z), seed, vec3(p.x, q.y, p.z)),
                       corner_noise(ivec3(j.xy, i.z), seed, vec3(q.xy, p.z)), t.x),
                   t.y);
  float far = mix(mix(corner_noise(ivec3(i.xy, j.z), seed, vec3(p.xy, q.z)),
                      corner_noise(ivec3(j.x, i.y, j.z), seed, vec3(q.x, p.y, q.z)), t.x),
                  mix(corner_noise(ivec3(i.x, j.yz), seed, vec3(p.x, q.yz)), corner_noise(j, seed, q), t.x), t.y);
  return clamp(mix(near, far, t.z), -1.0, 1.0);
}
#endif

float gradient_noise(vec3 point, uint seed) { return lattice_noise(point, seed, ~0); }

const float band_offset = 0.37;

// A fruit's point in cylindrical coordinates: radius, height, turns.
vec3 about_axis(vec3 position) {
  float radius = length(position.xz);
  return vec3(radius, position.y, radius > 0.0 ? atan(-position.z, position.x) / 6.283185307179586 : 0.0);
}

// One loop for both kinds of lattice (README.md says how loops are written here).
float band_noise(vec3 position, vec3 around, float frequency, vec3 stretch, int band, uint pattern) {
  bool isotropic = stretch == vec3(1.0);
  int rings = isotropic ? 1 : 2, ring = 0;
  vec2 radius_height = around.xy * frequency * stretch.xy + band_offset;
  float wanted = clamp(6.283185307179586 * around.x * frequency * stretch.z, 2.0, 32768.0);
  int inner = int(floor(log2(wanted)));
  float share = clamp(wanted / float(1 << inner) - 1.0, 0.0, 1.0);
  share = share * share * (3.0 - 2.0 * share);

  float sum = 0.0;
  do {
    int level = inner + ring;
    int cells = 1 << level;
    bool turns = !isotropic && level >= 2;
    vec3 point = isotropic ? position * frequency + band_offset * float(band + 1)
                           : vec3(radius_height, turns ? around.z * float(cells) : band_offset);
    uint seed = pattern + uint(band) + (isotropic ? 0u : 64u * uint(level));
    sum += (isotropic ? 1.0 : ring == 0 ? 1.0 - share : share) * lattice_noise(point, seed, turns ? cells - 1 : ~0);
  } while (++ring < rings);
  float norm = isotropic ? 1.0 : sqrt(share * share + (1.0 - share) * (1.0 - share));
  return clamp(sum / norm, -1.0, 1.0);
}

vec3 modulated(vec3 color, vec3 position, float footprint, int solid) {
  int first = solid * noise_texels;
  vec4 head = texelFetch(noise_styles, first);  // base frequency, sigma, keys, bands
  vec4 form = texelFetch(noise_styles, first + 1);
  vec3 stretch = form.xyz;
  uint pattern = uint(form.w);

  // The share of each key in this colour; from it the weight of each band and the direction.
  vec3 lab = to_oklab(color);
  float total = 0.0;
  vec3 axis = vec3(0.0);
  vec4 low = vec4(0.0), high = vec4(0.0);
  for (int k = 0; k < int(head.z); ++k) {
    int key = first + 2 + 4 * k;
    vec3 d = lab - texelFetch(noise_styles, key).xyz;
    float share = exp(-dot(d, d) / (2.0 * head.y * head.y)) + 1e-6;
    total += share;
    axis += share * texelFetch(noise_styles, key + 1).xyz;
    low += share * texelFetch(noise_styles, key + 2);
    high += share * texelFetch(noise_styles, key + 3);
  }

  float steepest = max(stretch.x, max(stretch.y, stretch.z));
  vec3 around = about_axis(position);
  float amount = 0.0, finest = 0.5 / (steepest * footprint);  // finer bands are not shown
  int bands = int(head.w), b = 0;
  do {
    float frequency = head.x * float(1 << b);
    float shown = 1.0 - smoothstep(0.25, 0.5, frequency * steepest * footprint);
    float part = b < bands ? (b < 4 ? low[b] : high[b - 4]) / total * shown : 0.0;
    if (abs(part) > 1e-4) amount += part * band_noise(position, around, frequency, stretch, b, pattern);
  } while (++b < bands && head.x * float(1 << b) < finest);
  return amount == 0.0 ? color : clamp(from_oklab(lab + amount * axis / total), 0.0, 1.0);
}

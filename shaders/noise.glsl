// Gradient noise [Perlin 2002] and the modulation of colours: the mirror of render/style/noise.cpp.
#include "color.glsl"

const int max_noise_keys = 16;
const int max_noise_bands = 8;

layout(std140) uniform NoiseBlock {
  vec4 noise_head;     // base frequency, sigma, keys, bands
  vec4 noise_stretch;  // along radius, height, azimuth
  vec4 noise_lab[max_noise_keys];
  vec4 noise_axis[max_noise_keys];
  vec4 noise_weights[2 * max_noise_keys];  // two a key: bands 0-3 and 4-7
};

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

float gradient_noise(vec3 point, uint seed) { return lattice_noise(point, seed, ~0); }

const float band_offset = 0.37;

float ring_noise(vec2 radius_height, float turn, int level, int band) {
  uint seed = uint(band) + 64u * uint(max(level, 1));
  if (level < 2) return gradient_noise(vec3(radius_height, band_offset), seed);
  int cells = 1 << level;
  return lattice_noise(vec3(radius_height, turn * float(cells)), seed, cells - 1);
}

float band_noise(vec3 position, float frequency, int band) {
  if (noise_stretch.xyz == vec3(1.0)) {
    return gradient_noise(position * frequency + band_offset * float(band + 1), uint(band));
  }
  float radius = length(position.xz);
  float turn = radius > 0.0 ? atan(-position.z, position.x) / 6.283185307179586 : 0.0;
  vec2 radius_height = vec2(radius, position.y) * frequency * noise_stretch.xy + band_offset;
  float cells = clamp(6.283185307179586 * radius * frequency * noise_stretch.z, 2.0, 32768.0);
  int level = int(floor(log2(cells)));
  float share = clamp(cells / float(1 << level) - 1.0, 0.0, 1.0);
  share = share * share * (3.0 - 2.0 * share);
  float inner = ring_noise(radius_height, turn, level, band);
  float outer = ring_noise(radius_height, turn, level + 1, band);
  float norm = sqrt(share * share + (1.0 - share) * (1.0 - share));
  return clamp(mix(inner, outer, share) / norm, -1.0, 1.0);
}

vec3 modulated(vec3 color, vec3 position, float footprint) {
  int keys = int(noise_head.z), bands = int(noise_head.w);
  if (bands == 0) return color;

  // How much of each key this colour is; with it, the weight of each band and the direction.
  vec3 lab = to_oklab(color);
  float total = 0.0;
  vec3 axis = vec3(0.0);
  vec4 low = vec4(0.0), high = vec4(0.0);
  for (int k = 0; k < keys; ++k) {
    vec3 d = lab - noise_lab[k].xyz;
    float share = exp(-dot(d, d) / (2.0 * noise_head.y * noise_head.y)) + 1e-6;
    total += share;
    axis += share * noise_axis[k].xyz;
    low += share * noise_weights[2 * k];
    high += share * noise_weights[2 * k + 1];
  }

  float steepest = max(noise_stretch.x, max(noise_stretch.y, noise_stretch.z));
  float amount = 0.0;
  for (int b = 0; b < bands; ++b) {
    float weight = (b < 4 ? low[b] : high[b - 4]) / total;
    float frequency = noise_head.x * float(1 << b);
    float shown = 1.0 - smoothstep(0.25, 0.5, frequency * steepest * footprint);
    if (weight != 0.0 && shown > 0.0) amount += weight * shown * band_noise(position, frequency, b);
  }
  if (amount == 0.0) return color;
  return clamp(from_oklab(lab + amount * axis / total), 0.0, 1.0);
}

// The picture: every pixel is the mean of its lit samples; ink comes later. PAPER: where there is no fruit.
#include "gbuffer.glsl"
#include "lit.glsl"
#include "paper.glsl"
#include "skin_pits.glsl"

uniform usampler2D ids;
uniform sampler2D depth;
uniform sampler2D albedo;
uniform sampler2D normal_line;
uniform sampler2D light;
uniform bool translucent;
uniform sampler2D arrives;  // sunlight through the fruit
uniform sampler2D leaves;
uniform bool hairy;
uniform sampler2D hairs;  // in front of everything else
uniform sampler2D glass;  // all transparent layers
uniform int samples_per_side;
uniform bool see_through;
uniform vec3 shadow_color;  // of a wash on white paper
uniform vec2 tangent;
uniform mat4 camera_to_scene;
uniform float pixel_angle;  // size of a pixel at distance 1

#ifdef DETAILED
#include "detail.glsl"
#include "guide_lattice.glsl"
uniform sampler2D guide_shares;  // of each detail
#endif

layout(location = 0) out vec4 picture;

// The coarse light of the neighbour with the sample's distance.
Seen light_at(ivec2 pixel, float distance_to) {
  ivec2 size = textureSize(light, 0);
  ivec2 from = pixel;
  vec4 best = texelFetch(light, pixel, 0);
  float error = abs(best.z - distance_to), near_enough = 0.01 * distance_to;
  int i = 0;
  do {
    int k = i < 4 ? i : i + 1;
    ivec2 there = clamp(pixel + ivec2(k % 3 - 1, k / 3 - 1), ivec2(0), size - 1);
    vec4 other = texelFetch(light, there, 0);
    if (error >= near_enough && abs(other.z - distance_to) < error) {
      error = abs(other.z - distance_to);
      best = other;
      from = there;
    }
  } while (++i < 8 && error >= near_enough);
  if (!translucent) return Seen(best.x, best.y, vec3(0.0), vec3(0.0));
  return Seen(best.x, best.y, texelFetch(arrives, from, 0).rgb, texelFetch(leaves, from, 0).rgb);
}

// The nearest surface at a sample, or the mean over a pixel.
struct Nearest {
  float depth;
  uint id;
  vec4 albedo;  // and the number of the material
  vec3 normal;
  float rim;  // of a part on a cut face: millimetres to its border
#ifdef DETAILED
  vec4 guide_share;
#endif
};

Nearest nearest_at(ivec2 at) {
  Nearest found;
  found.depth = texelFetch(depth, at, 0).r;
  found.id = texelFetch(ids, at, 0).r;
  found.albedo = texelFetch(albedo, at, 0);
  vec4 normal_rim = texelFetch(normal_line, at, 0);
  found.normal = normal_rim.xyz;
  found.rim = normal_rim.w;
#ifdef DETAILED
  found.guide_share = texelFetch(guide_shares, at, 0);
#endif
  return found;
}

// The mean of a pixel's samples if all show the same smooth face, or nothing; else false. Noise is no finer than a
// pixel, but details have sharp edges and need all samples.
bool is_one(ivec2 pixel, out Nearest mean) {
  mean = nearest_at(pixel * samples_per_side);
#ifdef DETAILED
  if (mean.guide_share != vec4(0.0)) return false;
#endif
  float near = mean.depth, far = mean.depth;
  int count = samples_per_side * samples_per_side, i = min(1, count - 1);  // a single sample is compared with itself
  do {
    Nearest other = nearest_at(pixel * samples_per_side + ivec2(i % samples_per_side, i / samples_per_side));
    if (other.id != mean.id || other.albedo.a != mean.albedo.a) return false;
    if (dot(other.normal, mean.normal) < 0.98 * length(mean.normal) * length(other.normal)) return false;
    near = min(near, other.depth);
    far = max(far, other.depth);
    float share = 1.0 / float(i + 1);
    mean.depth = mix(mean.depth, other.depth, share);
    mean.albedo.rgb = mix(mean.albedo.rgb, other.albedo.rgb, share);
    mean.normal = mix(mean.normal, other.normal, share);
    mean.rim = mix(mean.rim, other.rim, share);
#ifdef DETAILED
    if (other.guide_share != vec4(0.0)) return false;
#endif
  } while (++i < count);
  if (instance_of(mean.id) != 0u) mean.normal = normalize(mean.normal);
  if (far == 1.0) return near == 1.0;
  return distance_from_depth(far) < 1.01 * distance_from_depth(near);
}

// A layer in front of everything, at a sample or as the mean of a pixel. Premultiplied.
vec4 layer_at(sampler2D layer, ivec2 pixel, int sample_index, bool all) {
  vec4 sum = vec4(0.0);
  int count = all ? samples_per_side * samples_per_side : 1, i = 0;
  do {
    int k = all ? i : sample_index;
    sum += texelFetch(layer, pixel * samples_per_side + ivec2(k % samples_per_side, k / samples_per_side), 0);
  } while (++i < count);
  return sum / float(count);
}

#if defined(WINDOW) && !defined(PAPER)
// Juice climbs the walls around a wet part: over half a millimetre its surface leans away from them (a meniscus).
vec3 beside_rim(vec3 n, Nearest nearest, vec2 at, Material m) {
  float climbs = juice * smoothstep(1.1, 2.0, m.wet) * exp(-nearest.rim / 0.45);
  if (climbs < 0.02) return n;
  vec2 inwards = vec2(0.0);
  int k = 0;
  do {
    ivec2 aside = (k < 2 ? ivec2(1, 0) : ivec2(0, 1)) * (k % 2 == 0 ? 1 : -1) * samples_per_side;
    ivec2 there = clamp(ivec2(at) + aside, ivec2(0), textureSize(albedo, 0) - 1);
    if (texelFetch(albedo, there, 0).a != nearest.albedo.a) continue;
    inwards += vec2(aside) * (texelFetch(normal_line, there, 0).w - nearest.rim);
  } while (++k < 4);
  if (dot(inwards, inwards) < 1e-8) return n;
  vec3 way = mat3(camera_to_scene) * vec3(normalize(inwards), 0.0);
  way -= n * dot(way, n);
  return normalize(n + 0.75 * climbs * way / max(length(way), 0.2));
}
#endif

#ifdef WINDOW
// A little juice on the table next to pieces: it darkens the table, and reflects the window at its edge.
vec3 with_juice(vec3 table, float wetness, vec3 place, vec3 to_eye) {
  float uneven = gradient_noise(place * 70.0, 451u) + 0.35 * gradient_noise(place * 190.0, 452u);
  float depth = wetness + 0.25 * uneven - 0.2;
  float wet = smoothstep(0.0, 0.09, depth);
  if (wet <= 0.0) return table;
  float edge = wet * (1.0 - smoothstep(0.05, 0.16, depth));
  vec3 n = normalize(vec3(0.0, 1.0, 0.0) + 0.5 * edge * vec3(to_light.x, 0.0, to_light.z));
  float pane = window(n, to_eye, 0.12);
  vec3 mirrored = reflect(-to_eye, n);
  pane += edge * high_window(mirrored, to_light);
  vec3 gleam = of_water(dot(n, to_eye)) * (0.6 * room_at(mirrored, to_light) + 12.0 * pane);
  return mix(table, table * vec3(0.86, 0.83, 0.78) + gleam, juice * wet);
}
#endif

#ifndef PAPER
// `at`: in samples.
vec3 fruit_at(Nearest nearest, vec2 at, vec2 size, Seen seen, float distance_to, float grain_here) {
  vec2 ndc = 2.0 * at / size - 1.0;
  vec3 ray = vec3(ndc * tangent, -1.0) * distance_to;
  vec3 to_eye = normalize(mat3(camera_to_scene) * -ray);

  // The noise at the point in its fruit; a pixel covers more of a slanted face.
  uint instance = instance_of(nearest.id);
  bool cut = is_cut(nearest.id);
  vec3 fruit_position = in_fruit(instance, (camera_to_scene * vec4(ray, 1.0)).xyz);
  float footprint = pixel_angle * distance_to / max(dot(nearest.normal, to_eye), 0.3);
  int solid = int(pen_of(instance).z);
  vec3 color = modulated(nearest.albedo.rgb, fruit_position, footprint, solid);
  vec3 normal = nearest.normal;
#ifdef DETAILED
  vec4 way_layer = way_layer_at(solid, fruit_position, cut && nearest.guide_share != vec4(0.0));
  Detailed with_details = detailed(color, normal, nearest.albedo.rgb, turn_to_fruit(instance), fruit_position, footprint,
                                   solid, cut, way_layer, nearest.guide_share);
  color = with_details.color;
  normal = with_details.normal;
#endif
  Material material = material_at(nearest.albedo.a);
#ifdef WINDOW
  if (cut) normal = beside_rim(normal, nearest, at, material);
#endif
  vec4 pit = cut || material.pit > 0.0 ? vec4(0.0) : pit_at(solid, fruit_position, turn_to_fruit(instance) * nearest.normal);
  if (pit != vec4(0.0)) {
    vec3 slope = transpose(turn_to_fruit(instance)) * pit.xyz;
    normal = normalize(normal - (slope - nearest.normal * dot(slope, nearest.normal)));
    seen.sky *= 1.0 - 0.6 * pit.w;
  }
  vec3 lit = fruit_color(color, normal, to_eye, seen, cut, material, fruit_position, footprint, nearest.rim);
#ifdef WINDOW
  lit = developed(lit);
#endif
  return painted(lit, grain_here);
}
#endif

vec3 sample_color(Nearest nearest, vec2 at, vec2 size, ivec2 pixel, vec3 ground, float grain_here) {
  vec3 color = ground;
  if (nearest.depth < 1.0) {
    float distance_to = distance_from_depth(nearest.depth);
    Seen seen = light_at(pixel, distance_to);
    // The table is paper with a wash of shadow.
    color *= mix(shadow_color, vec3(1.0), seen.sun) * mix(0.82 * shadow_color, vec3(1.0), seen.sky);
#ifdef WINDOW
    float wetness = juice > 0.0 ? texelFetch(light, pixel, 0).w : 0.0;
    if (wetness > 0.0) {
      vec3 way = vec3((2.0 * at / size - 1.0) * tangent, -1.0) * distance_to;
      vec3 place = (camera_to_scene * vec4(way, 1.0)).xyz, to_eye = normalize(mat3(camera_to_scene) * -way);
      color = with_juice(color, wetness, place, to_eye);
    }
#endif
#ifndef PAPER
    if (instance_of(nearest.id) != 0u) color = fruit_at(nearest, at, size, seen, distance_to, grain_here);
#endif
  }
  return color;
}

void main() {
  // Rows of the picture run down.
  vec2 size = vec2(textureSize(depth, 0));
  ivec2 from_top = ivec2(gl_FragCoord.xy);
  ivec2 pixel = ivec2(from_top.x, textureSize(light, 0).y - 1 - from_top.y);
  float grain_here = grain > 0.0 ? paper_grain(from_top) : 0.0;
  vec3 ground = paper_color(from_top, vec2(textureSize(light, 0)), grain_here);

  Nearest mean;
  bool one = is_one(pixel, mean);
  int count = one ? 1 : samples_per_side * samples_per_side, i = 0;
  vec3 sum = vec3(0.0);
  do {
    ivec2 sample_at = pixel * samples_per_side + ivec2(i % samples_per_side, i / samples_per_side);
    Nearest nearest = mean;
    vec2 at = (vec2(pixel) + 0.5) * float(samples_per_side);
    if (!one) {
      nearest = nearest_at(sample_at);
      at = vec2(sample_at) + 0.5;
    }
    vec3 color = sample_color(nearest, at, size, pixel, ground, grain_here);
    if (see_through) {
      vec4 before = layer_at(glass, pixel, i, one);
      color = before.rgb + (1.0 - before.a) * clamp(color, 0.0, 1.0);
    }
    if (hairy) {
      vec4 before = layer_at(hairs, pixel, i, one);
      color = before.rgb + (1.0 - before.a) * clamp(color, 0.0, 1.0);
    }
    sum += clamp(color, 0.0, 1.0);
  } while (++i < count);
  picture = vec4(srgb_from_linear(sum / float(count)), 1.0);
}

// The picture: every pixel the mean of its samples, each lit; ink comes later.
#include "gbuffer.glsl"
#include "lit.glsl"
#include "paper.glsl"

uniform usampler2D ids;
uniform sampler2D depth;
uniform sampler2D albedo;
uniform sampler2D normal_line;
uniform sampler2D light;
uniform bool translucent;
uniform sampler2D arrives;  // sunlight through the fruit
uniform sampler2D leaves;
uniform bool hairy;
uniform sampler2D hairs;  // before all else
uniform sampler2D glass;  // all layers of what is see-through
uniform int samples_per_side;
uniform bool see_through;
uniform vec3 shadow_color;  // of a wash on white paper
uniform vec2 tangent;
uniform mat4 camera_to_scene;
uniform float pixel_angle;  // size of a pixel at distance 1

#ifdef DETAILED
#include "detail.glsl"
uniform sampler2D guide_ways;    // to the skin, and the depth of the layer
uniform sampler2D guide_shares;  // of each detail
#endif

layout(location = 0) out vec4 picture;

// The coarser light of the neighbour that lies at the sample's own distance.
Seen light_at(ivec2 pixel, float distance_to) {
  ivec2 size = textureSize(light, 0);
  ivec2 from = pixel;
  vec4 best = texelFetch(light, pixel, 0);
  float error = abs(best.z - distance_to);
  for (int i = 0; i < 8 && error >= 0.01 * distance_to; ++i) {
    int k = i < 4 ? i : i + 1;
    ivec2 there = clamp(pixel + ivec2(k % 3 - 1, k / 3 - 1), ivec2(0), size - 1);
    vec4 other = texelFetch(light, there, 0);
    if (abs(other.z - distance_to) < error) {
      error = abs(other.z - distance_to);
      best = other;
      from = there;
    }
  }
  if (!translucent) return Seen(best.x, best.y, vec3(0.0), vec3(0.0));
  return Seen(best.x, best.y, texelFetch(arrives, from, 0).rgb, texelFetch(leaves, from, 0).rgb);
}

vec3 sample_color(ivec2 at, vec2 size, ivec2 pixel, vec3 ground, float grain_here) {
  float d = texelFetch(depth, at, 0).r;
  if (d == 1.0) return ground;
  float distance_to = distance_from_depth(d);
  Seen seen = light_at(pixel, distance_to);
  uint id = texelFetch(ids, at, 0).r;
  if (instance_of(id) == 0u) {
    // The table is the paper, with a wash of shadow on it.
    return ground * mix(shadow_color, vec3(1.0), seen.sun) * mix(0.82 * shadow_color, vec3(1.0), seen.sky);
  }
  vec2 ndc = 2.0 * (vec2(at) + 0.5) / size - 1.0;
  vec3 ray = vec3(ndc * tangent, -1.0) * distance_to;
  vec3 to_eye = normalize(mat3(camera_to_scene) * -ray);
  vec3 normal = texelFetch(normal_line, at, 0).xyz;

  // The noise, where the point lies in its fruit; a pixel covers more of a slanted face.
  vec3 fruit_position = in_fruit(instance_of(id), (camera_to_scene * vec4(ray, 1.0)).xyz);
  float footprint = pixel_angle * distance_to / max(dot(normal, to_eye), 0.3);
  int solid = int(pen_of(instance_of(id)).z);
  vec4 plain = texelFetch(albedo, at, 0);
  vec3 color = modulated(plain.rgb, fruit_position, footprint, solid);
#ifdef DETAILED
  color = detailed(color, plain.rgb, fruit_position, footprint, solid, is_cut(id), texelFetch(guide_ways, at, 0),
                   texelFetch(guide_shares, at, 0));
#endif
  Material material = material_at(plain.a);
  return painted(fruit_color(color, normal, to_eye, seen, is_cut(id), material, fruit_position, footprint), grain_here);
}

void main() {
  // The picture's rows run down.
  vec2 size = vec2(textureSize(depth, 0));
  ivec2 from_top = ivec2(gl_FragCoord.xy);
  ivec2 pixel = ivec2(from_top.x, textureSize(light, 0).y - 1 - from_top.y);
  float grain_here = grain > 0.0 ? paper_grain(from_top) : 0.0;
  vec3 ground = paper_color(from_top, vec2(textureSize(light, 0)), grain_here);

  vec3 sum = vec3(0.0);
  for (int y = 0; y < samples_per_side; ++y) {
    for (int x = 0; x < samples_per_side; ++x) {
      ivec2 at = pixel * samples_per_side + ivec2(x, y);
      vec3 color = sample_color(at, size, pixel, ground, grain_here);
      if (see_through) {
        vec4 before = texelFetch(glass, at, 0);
        color = before.rgb + (1.0 - before.a) * clamp(color, 0.0, 1.0);
      }
      if (hairy) {
        vec4 before = texelFetch(hairs, at, 0);
        color = before.rgb + (1.0 - before.a) * clamp(color, 0.0, 1.0);
      }
      sum += clamp(color, 0.0, 1.0);
    }
  }
  picture = vec4(srgb_from_linear(sum / float(samples_per_side * samples_per_side)), 1.0);
}

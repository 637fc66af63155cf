// Where ink runs, from ids, depths and normals of neighbouring samples (Saito & Takahashi 1990; ALGORITHMS: the
// nearer side owns the line), and how wide it is there.
#include "gbuffer.glsl"
#include "noise.glsl"
#include "stroke_code.glsl"

uniform usampler2D ids;
uniform sampler2D depth;
uniform sampler2D normal_line;
uniform mat4 clip_to_scene;
uniform float inner_opacity;
uniform vec2 from_light;  // on the picture

layout(location = 0) out ivec2 stroke;

const ivec2 steps[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));

// Which way is out, seen over a few samples, so that strokes do not jump in width from sample to sample.
vec2 outwards(ivec2 at, uint id, bool from_piece) {
  ivec2 size = textureSize(ids, 0);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 12; ++i) {
    float angle = 0.5235988 * float(i);
    vec2 way = vec2(cos(angle), sin(angle));
    uint other = texelFetch(ids, clamp(at + ivec2(round(5.0 * way)), ivec2(0), size - 1), 0).r;
    bool outside = instance_of(other) != instance_of(id);
    if (outside == from_piece && (outside || is_cut(other) != is_cut(id))) sum += way;
  }
  return dot(sum, sum) > 0.01 ? normalize(sum) : vec2(0.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(ids, 0);
  stroke = ivec2(no_stroke);
  uint id = texelFetch(ids, at, 0).r;
  if (instance_of(id) == 0u) return;

  float depth_here = texelFetch(depth, at, 0).r;
  float here = distance_from_depth(depth_here);
  vec4 normal = texelFetch(normal_line, at, 0);
  float outline = 0.0;  // width, share of the instance's
  float inner = normal.w > 0.05 ? 1.0 : 0.0;
  float opacity = normal.w;
  float around[4];
  for (int i = 0; i < 4; ++i) {
    ivec2 there = clamp(at + steps[i], ivec2(0), size - 1);
    uint other = texelFetch(ids, there, 0).r;
    around[i] = distance_from_depth(texelFetch(depth, there, 0).r);
    if (other == id) continue;
    if (instance_of(other) != instance_of(id)) {
      // The table owns no line: before a piece it lies nearer to the eye than the piece does.
      if (instance_of(other) == 0u || here <= around[i]) outline = max(outline, 1.0);
    } else if (is_cut(id) != is_cut(other)) {
      if (is_cut(id)) outline = max(outline, 0.75);  // the rim belongs to the cut face
    } else if (id > other) {
      // The ridge between two cut faces, or where two surfaces meet.
      if (is_cut(id)) outline = max(outline, 0.6);
      else inner = 1.0, opacity = max(opacity, 0.8);
    }
  }

  // A fold of the solid in front of itself: on one side distance jumps, on the other it goes on as before.
  for (int i = 0; i < 4; i += 2) {
    float a = around[i] - here, b = around[i + 1] - here;
    if (a + b > 0.012 * here && a + b > 1.5 * min(abs(a), abs(b))) outline = max(outline, 0.8);
  }

  if (outline == 0.0 && inner == 0.0) return;
  vec4 ink = ink_of(instance_of(id));
  vec4 pen = pen_of(instance_of(id));

  // The hand: heavier away from the light, trembling along the line.
  vec4 scene_point = clip_to_scene * vec4(2.0 * (gl_FragCoord.xy / vec2(size)) - 1.0, 2.0 * depth_here - 1.0, 1.0);
  float tremble = 1.5 * gradient_noise(scene_point.xyz / scene_point.w / pen.x, 301u);
  float shade = outline > 0.0 ? dot(outwards(at, id, outline == 1.0), from_light) : 0.0;
  float hand = max(0.72 + 0.34 * tremble + 0.26 * shade, 0.22);
  if (outline > 0.0) {
    float reach = max(0.5 * ink.w * outline * hand, 0.5);
    stroke.x = packed_stroke(reach * reach, int(instance_of(id) & 0xffffu));
  }
  if (inner > 0.0) {
    float reach = max(0.5 * pen.y * (0.8 + 0.4 * tremble), 0.45);
    stroke.y = packed_stroke(reach * reach, int(255.0 * min(opacity, 1.0) * inner_opacity));
  }
}

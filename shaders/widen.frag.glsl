// Spreads strokes to their width along one direction; twice, across and up, makes them round.
#include "stroke_code.glsl"

uniform isampler2D strokes;
uniform bool across;  // or up
uniform isampler2D inked_tiles;
uniform int widest_reach;

layout(location = 0) out ivec2 stroke;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 direction = across ? ivec2(1, 0) : ivec2(0, 1);
  ivec2 size = textureSize(strokes, 0);
  stroke = texelFetch(strokes, at, 0).rg;

  // What comes from this tile and its two neighbours; up, also what came across from those beside them.
  ivec2 tile = at / stroke_tile, last = textureSize(inked_tiles, 0) - 1;
  int reach = 0;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      if (across && j != 0) continue;
      ivec2 there = tile + i * direction + j * direction.yx;
      reach = max(reach, texelFetch(inked_tiles, clamp(there, ivec2(0), last), 0).r);
    }
  }
  reach = min(reach, widest_reach);
  for (int i = 1; i <= reach; ++i) {
    int loss = (i * i * reach_unit) << 16;
    ivec2 a = texelFetch(strokes, min(at + i * direction, size - 1), 0).rg;
    ivec2 b = texelFetch(strokes, max(at - i * direction, ivec2(0)), 0).rg;
    ivec2 best = max(a, b);
    stroke = max(stroke, ivec2(best.x == no_stroke ? no_stroke : best.x - loss,
                               best.y == no_stroke ? no_stroke : best.y - loss));
  }
}

// How far the strokes of a tile of samples reach; 0 where there are none.
#include "stroke_code.glsl"

uniform isampler2D strokes;

layout(location = 0) out int reach;

void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * stroke_tile;
  ivec2 last = textureSize(strokes, 0) - 1;
  int most = no_stroke;
  for (int y = 0; y < stroke_tile; ++y) {
    for (int x = 0; x < stroke_tile; ++x) {
      ivec2 stroke = texelFetch(strokes, min(corner + ivec2(x, y), last), 0).rg;
      most = max(most, max(stroke.x, stroke.y));
    }
  }

  // Half a sample more: strokes end softly.
  reach = most == no_stroke ? 0 : int(ceil(sqrt(squared_reach(most)) + 1.0));
}

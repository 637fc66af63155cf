// How a stroke's reach travels from the line to the pixels beside it: r^2 - d^2 in 64ths of a squared sample, in
// the high bits, and whose stroke it is, or how opaque, in the low ones. The largest wins.
const int reach_unit = 64;
const int stroke_tile = 16;  // samples each way, in which strokes are looked for together
const int no_stroke = -0x40000000;

int packed_stroke(float squared_reach, int low_bits) {
  return (min(int(squared_reach * float(reach_unit)), 0x3fff) << 16) | low_bits;
}
float squared_reach(int stroke) { return float(stroke >> 16) / float(reach_unit); }
int low_bits(int stroke) { return stroke & 0xffff; }

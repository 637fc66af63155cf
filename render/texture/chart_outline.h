// A chart's outline, its possible orientations on the atlas, and the blocks of the atlas that it needs.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "render/texture/uv_charts.h"

namespace pomona {

/// The blocks that a chart needs, as rows of bits.
struct BlockMask {
  int width = 0, height = 0;
  std::vector<std::uint64_t> bits;  ///< words() per row
  std::int64_t count = 0;           ///< number of blocks

  BlockMask(int w, int h) : width(w), height(h), bits(static_cast<std::size_t>(words()) * h, 0) {}
  int words() const { return (width + 63) / 64; }
  void set(int x, int y) { bits[static_cast<std::size_t>(y) * words() + x / 64] |= std::uint64_t{1} << (x % 64); }
  bool has(int x, int y) const { return ((bits[static_cast<std::size_t>(y) * words() + x / 64] >> (x % 64)) & 1) != 0; }
};

/// The mask of one block.
BlockMask speck_mask();

/// The cosine and the sine of an angle, clockwise where y runs down.
using Turn = glm::dvec2;
inline glm::dvec2 turned(const Turn& turn, const glm::dvec2& p) {
  return {turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y};
}

/// The rotated chart; its smallest x and y are 0 again. Not for flat cut faces, which are not rotated.
Chart turned(const Chart& chart, const Turn& turn);

class ChartOutline {
 public:
  explicit ChartOutline(const Chart& chart);

  double area() const { return area_; }  ///< area of its triangles, square metres

  /// The possible rotations. A flat cut face is not rotated, so that the light on its ink is as in pictures. All others
  /// have the rotation with the smallest box, and steps of an eighth of a turn from there.
  const std::vector<Turn>& turns() const { return turns_; }

  /// The blocks whose texels a bilinear sample reads, at this scale. The lower corner of the rotated chart is in the
  /// middle of block (0, 0); a sample at p reads block floor(p) and its right and lower neighbours.
  BlockMask mask(const Turn& turn, double blocks_per_metre) const;

 private:
  std::vector<std::array<glm::dvec2, 2>> edges_;  // at which one triangle ends and no other begins
  std::vector<glm::dvec2> hull_;
  std::vector<Turn> turns_;
  double area_ = 0;
};

}  // namespace pomona

// Masks: the pixels of a picture that something covers.
#pragma once

#include <cstdint>
#include <vector>

#include "render/strokes/covered_pixels.h"

namespace pomona {

/// The pixels of a box, row by row: 1 = covered. visible_masks() and amodal_masks() make the smallest box.
struct Mask {
  PixelBox box;
  std::vector<std::uint8_t> covered;

  bool at(int x, int y) const {
    if (x < box.left || x > box.right || y < box.top || y > box.bottom) return false;
    return covered[static_cast<std::size_t>(y - box.top) * box.width() + (x - box.left)] != 0;
  }
  std::size_t area() const;  ///< pixels
};

/// The same mask in the smallest box around the covered pixels; an empty box if there are none.
Mask trimmed(const Mask& mask);

/// Per instance, the pixels with its number.
/// \param numbers from 1 to `count`, or 0; row by row.
std::vector<Mask> visible_masks(const std::vector<std::uint16_t>& numbers, int width, std::size_t count);

}  // namespace pomona

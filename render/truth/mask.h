// Masks: the pixels of a picture that something covers.
#pragma once

#include <cstdint>
#include <vector>

#include "render/strokes/covered_pixels.h"

namespace pomona {

/// The pixels of a box, row by row: 1 where covered. The box of what visible_masks() and amodal_masks() make is as
/// small as may be.
struct Mask {
  PixelBox box;
  std::vector<std::uint8_t> covered;

  bool at(int x, int y) const {
    if (x < box.left || x > box.right || y < box.top || y > box.bottom) return false;
    return covered[static_cast<std::size_t>(y - box.top) * box.width() + (x - box.left)] != 0;
  }
  std::size_t area() const;  ///< pixels
};

/// The same within the smallest box that holds what is covered; an empty box where nothing is.
Mask trimmed(const Mask& mask);

/// Per instance, where its number stands. \param numbers from 1 to `count`, or 0; row by row.
std::vector<Mask> visible_masks(const std::vector<std::uint16_t>& numbers, int width, std::size_t count);

}  // namespace pomona

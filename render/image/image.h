// Pictures in memory.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// Eight-bit sRGB, row by row from the top left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<glm::u8vec3> pixels;
  double dpi = 0;  ///< pixels per inch on paper; 0 = unsaid

  const glm::u8vec3& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

struct TransparentImage {
  Image image;
  std::vector<std::uint8_t> opacity;  ///< opacity of each pixel, 0..255, by rows as in the image
};

/// Longest side of a picture Pomona draws; what OpenGL implementations can hold as a texture.
constexpr int max_picture_side = 16384;

}  // namespace pomona

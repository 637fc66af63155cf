#include "render/compare/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace pomona {

Image heat_map(const FlipMap& map) {
  // Nine of magma's colours, evenly spaced, with linear interpolation.
  static constexpr std::array<std::array<double, 3>, 9> magma = {{{0, 0, 4},
                                                                  {28, 16, 68},
                                                                  {79, 18, 123},
                                                                  {129, 37, 129},
                                                                  {181, 54, 122},
                                                                  {229, 80, 100},
                                                                  {251, 135, 97},
                                                                  {254, 194, 135},
                                                                  {252, 253, 191}}};
  Image image{map.width, map.height, {}};
  for (const float error : map.error) {
    const double at = std::clamp(static_cast<double>(error), 0.0, 1.0) * (magma.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(at), magma.size() - 2);
    const double share = at - static_cast<double>(below);
    glm::u8vec3 pixel;
    for (std::size_t c = 0; c < 3; ++c) {
      pixel[static_cast<int>(c)] =
          static_cast<unsigned char>(std::floor(magma[below][c] * (1 - share) + magma[below + 1][c] * share + 0.5));
    }
    image.pixels.push_back(pixel);
  }
  return image;
}

}  // namespace pomona

#include "render/image/linear_pixels.h"

#include <array>

namespace pomona {

std::vector<Color> linear_pixels(const Image& picture) {
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = from_srgb8(glm::u8vec3(static_cast<std::uint8_t>(i))).x;
  std::vector<Color> pixels;
  pixels.reserve(picture.pixels.size());
  for (const glm::u8vec3& p : picture.pixels) pixels.emplace_back(linear[p.x], linear[p.y], linear[p.z]);
  return pixels;
}

Image image_of(const std::vector<Color>& pixels, int width, int height) {
  Image image{width, height, {}};
  image.pixels.reserve(pixels.size());
  for (const Color& pixel : pixels) image.pixels.push_back(to_srgb8(pixel));
  return image;
}

}  // namespace pomona

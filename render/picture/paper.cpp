#include "render/picture/paper.h"

#include "render/style/noise.h"

namespace pomona {

Paper::Paper(const Color& color, double grain) : color_(color), lab_(to_oklab(color)), grain_(grain) {}

Color Paper::at(int x, int y) const {
  if (grain_ == 0) return color_;

  // Lengths in pixels: the tooth, and flecks that lie about in no direction.
  const double tooth = gradient_noise({x / 1.9, y / 1.9, 0.5}, 201);
  const double fleck = gradient_noise({(x + y) / 9.0, (x - y) / 3.7, 0.5}, 202);
  const auto lightness = static_cast<float>(grain_ * (0.9 * tooth + 0.7 * fleck));
  return from_oklab_within_gamut(lab_ + glm::vec3(lightness, 0, 0));
}

}  // namespace pomona

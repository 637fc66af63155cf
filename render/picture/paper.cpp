#include "render/picture/paper.h"

#include "render/style/noise.h"

namespace pomona {

Paper::Paper(const Style& style, int width, int height)
    : color_(style.paper),
      lab_(to_oklab(style.paper)),
      paint_(style),
      grain_(style.grain),
      vignette_(style.vignette),
      granulation_(style.grain * style.granulation),
      width_(width),
      height_(height) {}

double Paper::grain_at(int x, int y) const {
  // Lengths in pixels: the tooth of the paper, and flecks without a direction.
  const double tooth = gradient_noise({x / 1.9, y / 1.9, 0.5}, 201);
  const double fleck = gradient_noise({(x + y) / 9.0, (x - y) / 3.7, 0.5}, 202);
  return 0.9 * tooth + 0.7 * fleck;
}

double Paper::age_at(int x, int y) const {
  // Grows towards the edges, a little in clouds: 1 in the corners.
  const double u = 2 * (x + 0.5) / width_ - 1, v = 2 * (y + 0.5) / height_ - 1;
  const double u4 = u * u * u * u, v4 = v * v * v * v;
  const double side = width_ < height_ ? width_ : height_;
  const double cloud = gradient_noise({3.1 * x / side, 3.1 * y / side, 0.5}, 203);
  return 1 - (1 - u4) * (1 - v4) + 0.35 * cloud;
}

Color Paper::at(int x, int y) const {
  if (grain_ == 0 && vignette_ == 0) return color_;
  glm::dvec3 lab(lab_);
  if (grain_ > 0) lab.x += grain_ * grain_at(x, y);
  // Old paper is darker and browner.
  if (vignette_ > 0) lab += vignette_ * age_at(x, y) * glm::dvec3(-1, 0.08, 0.22);
  return from_oklab_within_gamut(glm::vec3(lab));
}

Color Paper::painted(const Color& color, int x, int y) const {
  return paint_(color, granulation_ > 0 ? granulation_ * grain_at(x, y) : 0);
}

}  // namespace pomona

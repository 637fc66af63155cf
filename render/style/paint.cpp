#include "render/style/paint.h"

namespace pomona {

Color Paint::operator()(const Color& color, double lift) const {
  if (is_plain() && lift == 0) return color;
  glm::dvec3 lab(to_oklab(color));
  lab.x += lightness_;
  lab.x += lift;
  lab.y *= saturation_;
  lab.z *= saturation_;
  return from_oklab_within_gamut(glm::vec3(lab));
}

}  // namespace pomona

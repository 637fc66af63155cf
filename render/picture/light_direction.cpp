#include "render/picture/light_direction.h"

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"

namespace pomona {

glm::dvec3 light_direction(const ViewFrame& frame, double azimuth, double elevation) {
  const glm::dvec3 up(0, 1, 0), behind = glm::cross(frame.right, up);
  const glm::dvec3 level = reproducible::sin(azimuth) * frame.right + reproducible::cos(azimuth) * behind;
  return reproducible::cos(elevation) * level + reproducible::sin(elevation) * up;
}

glm::dvec3 light_direction(const View& view, const LightStyle& light) {
  return light_direction(view_frame(view), light.azimuth, light.elevation);
}

}  // namespace pomona

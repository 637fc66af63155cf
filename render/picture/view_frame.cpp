#include "render/picture/view_frame.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

ViewFrame view_frame(const View& view) {
  ViewFrame frame;
  const glm::dvec3 towards_eye = view.eye - view.target;
  frame.distance = glm::length(towards_eye);
  if (!(frame.distance > 0)) return {};
  frame.back = towards_eye / frame.distance;

  // Within a thousandth of the vertical, +Y does not define up.
  const bool vertical = std::fabs(frame.back.y) > 1 - 5e-7;
  const glm::dvec3 sky = vertical ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  frame.right = glm::normalize(glm::cross(sky, frame.back));
  frame.up = glm::cross(frame.back, frame.right);
  return frame;
}

}  // namespace pomona

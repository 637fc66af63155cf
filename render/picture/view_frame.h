// The axes of the camera, for exporters.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// Orthonormal and right-handed; a camera in Pomona and in glTF looks along -back.
struct ViewFrame {
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 up{0, 1, 0};
  glm::dvec3 back{0, 0, 1};
  double distance = 1;  ///< from eye to target, metres
};

/// Up is +Y as far as possible; looking straight down or up, the picture's top is -Z.
ViewFrame view_frame(const View& view);

}  // namespace pomona

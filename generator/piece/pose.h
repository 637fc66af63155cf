// The pose of a rigid body.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// A rigid placement: p -> rotation * p + translation, metres.
struct Pose {
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 translation{0};
};

}  // namespace pomona

// Poses in files whose third axis points up.
#pragma once

#include "generator/order/export_choices.h"
#include "generator/piece/pose.h"

namespace pomona {

/// A place of a scene, in which +Y is up, in a file with this axis up: (x, y, z) becomes (x, -z, y).
inline glm::dvec3 place_with_up(UpAxis up, const glm::dvec3& p) {
  return up == UpAxis::y ? p : glm::dvec3(p.x, -p.z, p.y);
}

/// The same of a rotation: the frames of meshes stay as they are.
inline glm::dquat rotation_with_up(UpAxis up, const glm::dquat& rotation) {
  constexpr double half_root = 0.70710678118654752;  // the quarter turn about X
  return up == UpAxis::y ? rotation : glm::dquat(half_root, half_root, 0, 0) * rotation;
}

}  // namespace pomona

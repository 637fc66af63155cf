// How a piece lies on the table, for a picture.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// From the table to the eye that looks at pieces laid out, unit length: steep enough that faces which look up are
/// seen well, and low enough that skin and thickness are.
glm::dvec3 eye_over_table();

/// The same for what stands as it grew, and has its cut faces at its side.
glm::dvec3 eye_beside_table();

/// The direction on the table in which long things lie: away from the eye and to the right, so that they run along a
/// picture's diagonal. Unit length, level.
glm::dvec3 diagonal_on_table();

struct TablePose {
  glm::dquat rotation{1, 0, 0, 0};
  bool slender = false;   ///< much longer than wide: it lies along diagonal_on_table()
  bool as_grown = false;  ///< hardly cut, it stands as the fruit did, or lies if that is long
};

/// The piece turned so that it rests on the table (+Y is up) as it would if laid down carefully, and that the eye sees
/// the most of its cut faces with some skin beside them: slices and halves on their backs, a half leaning a little
/// towards the eye, wedges on their sides. What has no cut faces to speak of stands as it grew, its cut faces
/// towards the eye, unless it is twice as long as wide: then it lies. What has flat ground under it stands, too,
/// however it is cut. \param eye eye_over_table() or eye_beside_table().
TablePose table_pose(const Solid& solid, const glm::dvec3& eye = eye_over_table());

/// The same for a piece beside a hanging peel: what has no flat cut faces stands as it grew, and is not laid down.
TablePose standing_pose(const Solid& solid, const glm::dvec3& eye);

}  // namespace pomona

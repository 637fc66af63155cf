// The pose of a piece on the table, for a picture.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// The direction from the table to the eye for pieces laid out, of length 1: steep enough to show faces that point up,
/// and low enough to show skin and thickness.
glm::dvec3 eye_over_table();

/// The same for pieces that stand as they grew, with cut faces at their sides.
glm::dvec3 eye_beside_table();

/// The direction of long pieces on the table: away from the eye and to the right, so that they run along the picture's
/// diagonal. Horizontal, of length 1.
glm::dvec3 diagonal_on_table();

struct TablePose {
  glm::dquat rotation{1, 0, 0, 0};
  bool slender = false;   ///< much longer than wide: it lies along diagonal_on_table()
  bool as_grown = false;  ///< hardly cut, it stands as the fruit did, or lies if that is long
};

/// The pose in which the piece rests on the table (+Y is up) as if laid down carefully, and the eye sees the most of
/// its cut faces, with some skin: slices and halves on their backs, a half leaning a little towards the eye, wedges on
/// their sides. A piece with hardly any cut faces stands as it grew, with these towards the eye; if it is twice as long
/// as wide, it lies. A piece with a flat bottom stands, too, however it is cut. \param eye eye_over_table() or
/// eye_beside_table().
TablePose table_pose(const Solid& solid, const glm::dvec3& eye = eye_over_table());

/// The same for a piece beside a hanging peel: a piece without flat cut faces stands as it grew and is not laid down.
TablePose standing_pose(const Solid& solid, const glm::dvec3& eye);

}  // namespace pomona

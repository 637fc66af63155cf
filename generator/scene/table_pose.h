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

/// Radians: a field of view so narrow that the ends of a row look like its middle. From near by, of two long pieces
/// along the diagonal the left one is seen from its side, and the right one from its end.
constexpr double narrow_field = 0.14;

struct TablePose {
  glm::dquat rotation{1, 0, 0, 0};
  bool slender = false;   ///< much longer than wide: it lies along diagonal_on_table()
  bool as_grown = false;  ///< hardly cut, it stands as the fruit did, or lies if that is long
  bool on_back = false;   ///< its largest cut face looks up
  glm::dvec3 face{0};     ///< in the piece's own frame, to where that face looks; 0 if it is not flat
};

/// The pose in which the piece rests on the table (+Y is up) as if laid down carefully, and the eye sees the most of
/// its cut faces, with some skin: slices and halves on their backs, a half leaning a little towards the eye, wedges on
/// their sides. A piece with hardly any cut faces stands as it grew, with these towards the eye; if it is twice as long
/// as wide, it lies. A piece with a flat bottom stands, too, however it is cut. \param eye eye_over_table() or
/// eye_beside_table().
TablePose table_pose(const Solid& solid, const glm::dvec3& eye = eye_over_table());

/// Whether these are the halves of a fruit that was cut lengthwise, of which one lies on its back at least.
bool are_halves(const TablePose& one, const TablePose& other);

/// The pose of the other half, `piece`, like that of the half that lies as `model`: faces at the same slant are of one
/// scale in a picture, while each half by itself would roll to its own side.
TablePose posed_alike(const TablePose& piece, const TablePose& model);

/// table_pose() of a piece beside a hanging peel: one without flat cut faces stands as it grew and is not laid down.
TablePose standing_pose(const Solid& solid, const glm::dvec3& eye);

}  // namespace pomona

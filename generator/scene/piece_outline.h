// The outline of a piece: on what it can rest, and how long and wide it is.
#pragma once

#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// The outermost of a piece's vertices in many directions, and its centre of mass.
class PieceOutline {
 public:
  explicit PieceOutline(const Solid& solid);

  double radius() const { return radius_; }

  /// The height of the centre of mass above the table with this side up, metres.
  double height(const glm::dvec3& up) const { return -glm::dot(lowest(up), up); }

  /// The side that is up after the piece was laid down with `up` up and came to rest. It tilts in smaller and smaller
  /// steps, away from the point on which it stands.
  glm::dvec3 rested(glm::dvec3 up) const;

  struct Plan {
    glm::dvec3 along{0};  ///< level, unit length
    double ratio = 1;     ///< ratio of length to width
  };
  /// Seen from above.
  Plan plan(const glm::dvec3& up) const;

 private:
  glm::dvec3 lowest(const glm::dvec3& up) const;
  double extent(const glm::dvec3& along) const;

  glm::dvec3 center_;
  double radius_ = 0;
  std::vector<glm::dvec3> arms_;
};

/// Some unit vector at right angles to this one.
glm::dvec3 level_direction(const glm::dvec3& up);

/// Whether a piece that stands as it grew (+Y is up) would balance on something thin, as a beetroot on its root: the
/// mean distance of its lowest fifth's surface from the middle of that fifth is at most a sixteenth of the piece's
/// width. A cone on its tip is a little wider there, a strawberry three times as wide.
bool stands_on_a_tail(const Solid& solid);

/// Whether a piece that stands as it grew has a flat bottom, as a volcano has: at its lowest points, the skin faces
/// straight down, with six tenths of the area of everything that faces down; and it is not taller than wide.
bool stands_on_flat_ground(const Solid& solid);

}  // namespace pomona

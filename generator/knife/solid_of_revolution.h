// Solids of revolution: what a melon baller, a corer or a drawn profile takes out of a fruit.
#pragma once

#include "generator/base/curve.h"
#include "generator/mesh/closed_surface.h"

namespace pomona {

struct RevolveOptions {
  double tolerance = 2e-5;  ///< metres by which a chord around the axis may stray from its circle
};

/// The solid that a profile sweeps around the axis +Y: x is the distance from the axis, y the height, metres. The ends
/// of an open profile are joined to the axis by flat discs; a closed one makes a ring. The profile must not cross
/// itself, and may meet the axis with its ends only. Rows get fewer triangles towards the axis, so that none is a
/// sliver. \throws Error (usage) if so many triangles would be needed that nothing could be cut with them.
ClosedSurface revolved(const Curve& profile, const RevolveOptions& options = {});

/// Half a circle from pole to pole, for a ball around the origin; a chord strays from it by `tolerance` at most.
Curve half_circle(double radius, double tolerance);

/// Where a solid goes. `axis` and `up` are unit vectors, perpendicular to each other.
struct SolidPose {
  glm::dvec3 at{0};          ///< of the solid's origin
  glm::dvec3 axis{0, 1, 0};  ///< of its +Y
  glm::dvec3 up{0, 0, 1};    ///< of its +Z
};
ClosedSurface posed(ClosedSurface solid, const SolidPose& pose);

/// A unit vector perpendicular to this unit vector: level, or where that cannot be, +Z.
glm::dvec3 level_beside(const glm::dvec3& direction);

}  // namespace pomona

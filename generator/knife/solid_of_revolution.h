// Solids of revolution, for melon ballers, corers and drawn profiles.
#pragma once

#include "generator/base/curve.h"
#include "generator/mesh/closed_surface.h"

namespace pomona {

struct RevolveOptions {
  double tolerance = 2e-5;  ///< largest distance of a chord around the axis from its circle, metres
};

/// The solid that a profile makes when it turns around the axis +Y: x is the distance from the axis, y the height,
/// metres. Flat discs join the ends of an open profile to the axis; a closed profile makes a ring. The profile must not
/// cross itself; only its ends may touch the axis. Rows near the axis have fewer triangles, so that none is a sliver.
/// \throws Error (usage) if it needs more triangles than can be cut with.
ClosedSurface revolved(const Curve& profile, const RevolveOptions& options = {});

/// Half a circle from pole to pole, for a ball around the origin. A chord differs from it by at most `tolerance`,
/// metres.
Curve half_circle(double radius, double tolerance);

/// The pose of a solid. `axis` and `up` have length 1 and are perpendicular to each other.
struct SolidPose {
  glm::dvec3 at{0};          ///< position of the solid's origin, metres
  glm::dvec3 axis{0, 1, 0};  ///< direction of its +Y
  glm::dvec3 up{0, 0, 1};    ///< direction of its +Z
};
ClosedSurface posed(ClosedSurface solid, const SolidPose& pose);

/// A unit vector perpendicular to this unit vector: a horizontal one, or +Z if `direction` is vertical.
glm::dvec3 level_beside(const glm::dvec3& direction);

}  // namespace pomona

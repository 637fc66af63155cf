// Closed knives for tests.
#pragma once

#include "generator/knife/knife.h"

namespace pomona::shapes {

/// A ball: an octahedron with each edge in `n` pieces, its vertices moved to the sphere.
ClosedSurface ball(const glm::dvec3& center, double radius, int n);

/// An axis-aligned box of twelve triangles.
ClosedSurface block(const glm::dvec3& low, const glm::dvec3& high);

/// An upright cylinder with `around` sides.
ClosedSurface rod(const glm::dvec3& bottom, double radius, double height, int around);

/// The surface, turned about the origin to a generic position.
ClosedSurface tilted(ClosedSurface solid);

Knife solid_knife(ClosedSurface solid);

}  // namespace pomona::shapes

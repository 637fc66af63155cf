// Closed knives for tests.
#pragma once

#include "generator/cut/knife.h"

namespace pomona::shapes {

/// A ball: an octahedron with each edge in `n` pieces, blown up.
KnifeSolid ball(const glm::dvec3& center, double radius, int n);

/// An axis-aligned box of twelve triangles.
KnifeSolid block(const glm::dvec3& low, const glm::dvec3& high);

/// An upright cylinder with `around` sides.
KnifeSolid rod(const glm::dvec3& bottom, double radius, double height, int around);

/// The same surface, turned about the origin to a generic position.
KnifeSolid tilted(KnifeSolid solid);

Knife solid_knife(KnifeSolid solid);

}  // namespace pomona::shapes

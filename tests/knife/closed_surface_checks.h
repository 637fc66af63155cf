// Checks that tests make on closed surfaces.
#pragma once

#include <glm/vec3.hpp>

#include "generator/mesh/closed_surface.h"

namespace pomona {

/// The volume by the divergence theorem, cubic metres; positive if triangles face outwards.
double volume_of(const ClosedSurface& surface);

/// The area, square metres.
double area_of(const ClosedSurface& surface);

/// Whether every edge belongs to two triangles that pass it in opposite directions, and every point to a triangle.
bool is_closed(const ClosedSurface& surface);

/// The thinnest triangle's height, as a share of its longest edge.
double thinnest_of(const ClosedSurface& surface);

}  // namespace pomona

// What tests ask of closed surfaces.
#pragma once

#include <glm/vec3.hpp>

#include "generator/mesh/closed_surface.h"

namespace pomona {

/// By the divergence theorem, cubic metres; positive for triangles that face outwards.
double volume_of(const ClosedSurface& surface);

/// Square metres.
double area_of(const ClosedSurface& surface);

/// Every edge belongs to two triangles that run along it in opposite directions, and no point lies loose.
bool is_closed(const ClosedSurface& surface);

/// The thinnest triangle's height, as a share of its longest edge.
double thinnest_of(const ClosedSurface& surface);

}  // namespace pomona

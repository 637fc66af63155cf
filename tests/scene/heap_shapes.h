// Solids for settling tests: closed meshes made by code.
#pragma once

#include <string>
#include <vector>

#include "generator/piece/solid.h"

namespace pomona::heap_shapes {

Solid ball(double radius);

/// A flat ring: a torus whose tube is square, about the y axis.
Solid ring(double outer, double inner, double height);

/// The part of a ball between two half planes from its axis.
Solid wedge(double radius, double degrees);

/// A flat cylinder about the y axis, its lower face at y = 0; both faces count as cut.
Solid disc(double radius, double height);

/// A box that stands on y = 0: length, height, width.
Solid slab(const glm::dvec3& size);

/// The same with a hollow from above; `wall` is the thickness of walls and floor.
Solid tray(const glm::dvec3& size, double wall);

/// A square without thickness, standing on an edge.
Solid upright_sheet(double size);

/// A round bowl that stands on y = 0: a shallow curve inside, a wall of 5 mm.
Solid bowl(double radius, double depth);

}  // namespace pomona::heap_shapes

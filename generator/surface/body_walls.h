// Which bodies contain a point.
#pragma once

#include "generator/mesh/enclosures.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// The boundary triangles, facing air, grouped by the number of their body.
Enclosures body_walls(const DiffusionSurfaces& surfaces, const Bodies& bodies);

}  // namespace pomona

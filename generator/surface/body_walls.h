// Which bodies hold a place.
#pragma once

#include "generator/mesh/enclosures.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// The boundary, facing air: each triangle a part of the mesh that has its body's number.
Enclosures body_walls(const DiffusionSurfaces& surfaces, const Bodies& bodies);

}  // namespace pomona

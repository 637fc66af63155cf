// A coarse solid made round for pictures that show it large.
#pragma once

#include "generator/piece/solid.h"

namespace pomona {

/// The solid with every triangle parted into four, `passes` times; new vertices are pulled towards the tangent planes
/// of their edge's ends, so that it is as round as its normals say (Phong tessellation, Boubekeur and Alexa 2008).
/// Closed where it was closed.
Solid smoothed(Solid solid, int passes);

}  // namespace pomona

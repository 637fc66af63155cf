// The same piece with another ripeness: other colours on the same mesh.
#pragma once

#include "generator/piece/solid.h"
#include "generator/template/template.h"

namespace pomona {

/// The piece with the skin colours of `other` instead of its own. A vertex on a surface of `own` gets the colour of the
/// same point and side on `other`; where a knife has exposed the surface, it is browned as `fruit` says. Cut faces do
/// not change. \param own, other surfaces of the same individual, as swept, which differ only in their colours. \param
/// fruit the template of `other`. \throws Error (bug) if they differ in anything else.
Solid recolored(Solid piece, const DiffusionSurfaces& own, const DiffusionSurfaces& other, const Template& fruit);

}  // namespace pomona

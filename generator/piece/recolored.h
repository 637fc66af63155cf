// The same piece of a fruit that is riper, or less ripe: other colours on the same mesh.
#pragma once

#include "generator/piece/solid.h"
#include "generator/template/template.h"

namespace pomona {

/// The piece with the skin colours of `other` in place of its own: where a vertex lies on a surface of the one fruit,
/// it takes the colour of the same place and side on the other, and where a knife has laid the surface bare it browns
/// as `fruit` says, which is the other. Cut faces are left as they are. \param own, other of one individual, as swept:
/// they differ in nothing but colours. \throws Error (bug) if they do.
Solid recolored(Solid piece, const DiffusionSurfaces& own, const DiffusionSurfaces& other, const Template& fruit);

}  // namespace pomona

// The surface of a closed knife in cut faces that can be looked at.
#pragma once

#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"

namespace pomona {

/// With the section on each smooth face (Face::facet, as it comes) parted into cut faces that turn their front to one
/// side: seen from there none of their triangles is turned away. A bowl is one; a tube is two halves, front and back.
Face charted(Face face, const Regions& regions, int knife);

}  // namespace pomona

// Divides the surface of a closed knife into cut faces that can each be seen from one direction.
#pragma once

#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"

namespace pomona {

/// The face with the section on each smooth part (Face::facet in the input) divided into cut faces. From one direction,
/// all triangles of a cut face show their front. A bowl is one cut face; a tube is two halves.
Face charted(Face face, const Regions& regions, int knife);

}  // namespace pomona

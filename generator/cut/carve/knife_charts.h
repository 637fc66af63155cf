// The surface of a closed knife in cut faces that can be looked at.
#pragma once

#include "generator/cut/section/face_mesh.h"
#include "generator/cut/section/regions.h"

namespace pomona {

/// Parts the section on each smooth face (FaceMesh::solid->facet, as it comes) into cut faces that turn their front to
/// one side: seen from there none of their triangles is turned away. A bowl is one; a tube is two halves, front and
/// back.
void find_charts(FaceMesh& face, const Regions& regions, int knife);

}  // namespace pomona

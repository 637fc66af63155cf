// Pieces: what the knives leave, clipped skin and cut faces joined into solids.
#pragma once

#include <vector>

#include "generator/cut/cut.h"
#include "generator/cut/section.h"

namespace pomona {

/// New vertices on the skin's edges are added to `mesh`.
std::vector<CutPiece> pieces(SplitMesh& mesh, const FaceMeshes& faces, const Section& section,
                             const DiffusionSurfaces& surfaces, const CutOptions& options);

}  // namespace pomona

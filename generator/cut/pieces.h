// Pieces: what the knives leave, clipped skin and cut faces joined into solids.
#pragma once

#include <vector>

#include "generator/cut/cut.h"
#include "generator/cut/section/clipped_skin.h"
#include "generator/cut/section/section.h"

namespace pomona {

/// Of surfaces that are clipped; of their inner triangles nothing is taken. Points of the mesh that triangles and caps
/// name are one for each place.
std::vector<CutPiece> pieces(const SplitMesh& mesh, const std::vector<SkinTriangle>& clipped, const Section& section,
                             const DiffusionSurfaces& surfaces, const CutOptions& options);

}  // namespace pomona

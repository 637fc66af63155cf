// The first step of a cut along planes and strokes: splits all surfaces along them (paper, section 3.2).
#pragma once

#include "generator/cut/section/split_mesh.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Splits all triangles so that each lies in one cell; records its cell, and the edges at which it is cut.
SplitMesh split(const DiffusionSurfaces& surfaces, const CutPlanes& planes);

}  // namespace pomona

// The first step of a cut along planes and strokes: all surfaces split where these pass through them (paper, section
// 3.2).
#pragma once

#include "generator/cut/section/split_mesh.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Triangles that lie in no cell by halves, each with the cell it lies in and the edges it is cut at.
SplitMesh split(const DiffusionSurfaces& surfaces, const CutPlanes& planes);

}  // namespace pomona

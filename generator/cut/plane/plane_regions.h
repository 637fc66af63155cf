// Between which cells of planes and strokes the patches of a cut face lie.
#pragma once

#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"
#include "generator/knife/cut_planes.h"
#include "generator/surface/bodies.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The regions of a plane or a stroke. A patch inside a body is section where it has different cells on its two sides.
Regions plane_regions(const Face& face, const CutPlanes& planes, const DiffusionSurfaces& surfaces,
                      const Bodies& bodies);

}  // namespace pomona

// The triangles of a split mesh, split once more where cut faces have points on their edges, so that surfaces and cut
// faces share all vertices.
#pragma once

#include <vector>

#include "generator/cut/plane/edge_point.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/cut/section/split_mesh.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct SurfaceClipOptions {
  bool inner_too = false;  ///< all surfaces, for later knives; else only the boundary
};

struct ClippedSurfaces {
  SplitMesh mesh;  ///< with new vertices on edges; vertices refer to the representative of their point (same_as)
  std::vector<SurfaceTriangle> surface;
};

/// `edge_points` are sorted, each once.
ClippedSurfaces clipped_surfaces(SplitMesh mesh, const std::vector<EdgePoint>& edge_points,
                                 const DiffusionSurfaces& surfaces, const SurfaceClipOptions& options);

}  // namespace pomona

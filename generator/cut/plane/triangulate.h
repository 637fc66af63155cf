// Triangulates all blades: the faces that they cut, and what these add to the split mesh (paper, section 3.2, Figure
// 3b).
#pragma once

#include <vector>

#include "generator/cut/plane/edge_point.h"
#include "generator/cut/section/cut_options.h"
#include "generator/cut/section/face.h"
#include "generator/cut/section/segments.h"
#include "generator/cut/section/split_mesh.h"
#include "generator/surface/bodies.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct PlaneFaces {
  SplitMesh mesh;                     ///< with the points of the faces; same_as is complete
  std::vector<Face> faces;            ///< in cut order
  std::vector<EdgePoint> edge_point;  ///< points that faces have added to edges of the mesh; sorted, each once
};

/// \param segments of each plane.
PlaneFaces triangulate(SplitMesh mesh, const CutPlanes& planes, const std::vector<std::vector<CutSegment>>& segments,
                       const DiffusionSurfaces& surfaces, const Bodies& bodies, const CutOptions& options);

}  // namespace pomona

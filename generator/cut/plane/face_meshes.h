// All cutting sheets triangulated, and what they add to the split mesh.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "generator/cut/cut.h"
#include "generator/cut/section/face_mesh.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// A place on an edge of the split mesh that a triangulation put a point on.
struct EdgePoint {
  std::uint32_t low = 0, high = 0;  ///< the edge's ends: points, low < high
  double share = 0;                 ///< 0 at low, 1 at high
  std::uint32_t point = 0;
  auto operator<=>(const EdgePoint&) const = default;
};

/// All planes' triangulations, and what they add to the split mesh.
struct FaceMeshes {
  std::vector<FaceMesh> faces;         ///< in cut order
  std::vector<EdgePoint> edge_point;   ///< sorted, each once
  std::vector<std::uint32_t> same_as;  ///< per point of the split mesh: the first point that shares its place
};

/// Triangulates every plane. New points are added to `mesh`.
FaceMeshes triangulate(SplitMesh& mesh, const CutPlanes& planes, const std::vector<std::vector<Segment>>& segments,
                       const DiffusionSurfaces& surfaces, const Bodies& bodies, const CutOptions& options);

}  // namespace pomona

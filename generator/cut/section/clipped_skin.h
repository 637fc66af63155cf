// The boundary triangles of the split mesh, split once more where cut faces put points on their edges, so that skin
// and cut faces meet vertex to vertex.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/cut/plane/face_meshes.h"

namespace pomona {

struct SkinTriangle {
  std::array<std::uint32_t, 3> vertex{};  ///< of the split mesh; counter-clockwise seen from air
  std::uint32_t source = 0;
  std::uint32_t cell = 0;
};

/// New vertices on edges are added to `mesh`, and of its points at one place every vertex names the first.
std::vector<SkinTriangle> clipped_skin(SplitMesh& mesh, const FaceMeshes& faces, const DiffusionSurfaces& surfaces);

/// The same of all surfaces; inner triangles are turned as they were.
std::vector<SkinTriangle> clipped_surfaces(SplitMesh& mesh, const FaceMeshes& faces, const DiffusionSurfaces& surfaces);

}  // namespace pomona

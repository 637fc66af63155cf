// The cross-section put together from all triangulated planes (paper, Figure 3c).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/cut/face_mesh.h"
#include "generator/cut/regions.h"

namespace pomona {

/// A triangle of the section as pieces see it.
struct Cap {
  std::array<std::uint32_t, 3> point{};  ///< of the split mesh, first of those at one place
  std::array<std::uint32_t, 2> cell{};   ///< on the face's negative and positive side
  std::vector<BodyWinding> inside;
};

struct Section {
  CrossSection mesh;
  std::vector<Cap> cap;  ///< per triangle of the mesh
};

Section assemble(const FaceMeshes& faces, const std::vector<Regions>& regions, const SplitMesh& mesh,
                 const DiffusionSurfaces& surfaces, const CutPlanes& planes);

}  // namespace pomona

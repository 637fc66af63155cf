// The cross-section put together from all triangulated planes (paper, Figure 3c).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/plane/face_meshes.h"
#include "generator/cut/section/regions.h"

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

/// Without triangles that rounding to float closes to a line: their neighbours then meet there.
Section assemble(const FaceMeshes& faces, const std::vector<Regions>& regions, const SplitMesh& mesh,
                 const DiffusionSurfaces& surfaces, Threads threads = {});

/// With them, for knives that are still to come.
Section assemble_all(const FaceMeshes& faces, const std::vector<Regions>& regions, const SplitMesh& mesh,
                     const DiffusionSurfaces& surfaces, Threads threads);
void leave_out_collapsed(Section& section);

/// Without the triangles that are marked; there may be fewer marks than triangles.
void leave_out(Section& section, std::span<const std::uint8_t> gone);

/// Per point of the split mesh, the section's vertex to be diffused there that all its faces share.
using SharedVertices = std::map<std::uint32_t, std::uint32_t>;

/// Adds one more face, which takes vertices to be diffused from `shared` where there are any.
void add_face(Section& section, const FaceMesh& face, const Regions& regions, const SplitMesh& mesh,
              const DiffusionSurfaces& surfaces, const SharedVertices& shared);

}  // namespace pomona

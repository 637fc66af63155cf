// The cross-section as it grows, face by face (paper, Figure 3c).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "generator/cut/section/face_part.h"
#include "generator/cut/section/split_mesh.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct Section {
  CrossSection mesh;
  std::vector<Cap> cap;  ///< per triangle of the mesh
};

/// Of a fruit that nobody has cut yet.
Section empty_section(const DiffusionSurfaces& surfaces);

/// Per point of the split mesh, the section's vertex to be diffused there that all its faces share.
using SharedVertices = std::map<std::uint32_t, std::uint32_t>;

/// With the parts of more faces, one after another, which take vertices to be diffused from `shared` where there are
/// any.
Section with_parts(Section section, std::vector<FacePart> parts, const SplitMesh& mesh, SharedVertices shared);

/// Without the triangles that are marked; there may be fewer marks than triangles.
Section without(Section section, std::span<const std::uint8_t> gone);

/// Without triangles that rounding to float closes to a line: their neighbours then meet there. Knives that are still
/// to come need them.
Section without_collapsed(Section section);

}  // namespace pomona

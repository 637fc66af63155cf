// The cross-section while faces are added to it (paper, Figure 3c).
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

/// The empty section of a fruit that has not been cut.
Section empty_section(const DiffusionSurfaces& surfaces);

/// Per point of the split mesh: the interior vertex of the section that all faces share there.
using SharedVertices = std::map<std::uint32_t, std::uint32_t>;

/// The section with the parts of more faces, one after another. They use the interior vertices of `shared` where
/// possible.
Section with_parts(Section section, std::vector<FacePart> parts, const SplitMesh& mesh, SharedVertices shared);

/// The section without the marked triangles. There may be fewer marks than triangles.
Section without(Section section, std::span<const std::uint8_t> gone);

/// The section without triangles that rounding to float reduces to a line: their neighbours then meet there. Call it
/// after the last knife, because later knives need these triangles.
Section without_collapsed(Section section);

}  // namespace pomona

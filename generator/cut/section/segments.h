// Cut segments: where diffusion surfaces meet a cutting plane (paper, Figure 3a).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/section/split_mesh.h"

namespace pomona {

/// An edge of the split mesh along which a surface passes through a plane. Seen from the plane's positive side, the
/// front of the surface is left of the way from `from` to `to`.
struct CutSegment {
  std::uint32_t from = 0, to = 0;                // points
  std::uint32_t from_vertex = 0, to_vertex = 0;  // the same, with the surface's attributes
  std::uint32_t source = 0;                      // input triangle
};

/// The segments of each plane. Where a surface only touches a plane, coming and going along one edge, there is none.
std::vector<std::vector<CutSegment>> cut_segments(const SplitMesh& mesh, const DiffusionSurfaces& surfaces, int planes);

/// Edges used in both directions by one surface cancel in pairs; what is left keeps its order.
std::vector<CutSegment> without_mere_touches(std::vector<CutSegment> segments, const DiffusionSurfaces& surfaces);

}  // namespace pomona

// Cut segments: the intersections of diffusion surfaces with a cutting plane (paper, Figure 3a).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/section/split_mesh.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// An edge of the split mesh along which a surface passes through a plane. For a viewer on the plane's positive side,
/// the front of the surface is left of the direction from `from` to `to`.
struct CutSegment {
  std::uint32_t from = 0, to = 0;                // points
  std::uint32_t from_vertex = 0, to_vertex = 0;  // the same, with the surface's attributes
  std::uint32_t source = 0;                      // input triangle
};

/// The segments of each plane. There is none where a surface only touches a plane along an edge and returns.
std::vector<std::vector<CutSegment>> cut_segments(const SplitMesh& mesh, const DiffusionSurfaces& surfaces,
                                                  const Bodies& bodies, int planes);

/// Removes pairs of segments in which one surface of one body uses an edge in both directions. The others keep their
/// order. Bodies that touch along a triangle each keep theirs: either is bounded there.
std::vector<CutSegment> without_mere_touches(std::vector<CutSegment> segments, const DiffusionSurfaces& surfaces,
                                             const Bodies& bodies);

}  // namespace pomona

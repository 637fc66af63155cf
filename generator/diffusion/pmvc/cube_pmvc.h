// The reference for positive mean values: the view of a point in all directions of a cube, in double precision.
#pragma once

#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/pmvc_value.h"
#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// Draws the surfaces onto the six faces of a world-aligned cube of 6 x texels^2 directions around every point, nearest
/// first, and sums the visible colours [paper, section 3.2]. `texels` is a multiple of 8.
///
/// A triangle with corners a, b, c relative to the point covers the direction D where the three edge functions
/// (a x b) . D, (b x c) . D, (c x a) . D have the sign of its volume det(a, b, c); each is exactly the negative
/// of its neighbour's across the edge, so that nothing slips between two triangles [Davidovic et al., "3D
/// rasterization", 2012]. 1 / d and c / d are linear in D on a triangle: the texels it wins are summed first,
/// and shaded at once. Equal depths go to the smaller triangle index.
std::vector<PmvcValue> cube_pmvc(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                 std::span<const glm::vec3> points, int texels, Threads threads = {});

}  // namespace pomona

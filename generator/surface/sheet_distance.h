// How far the sheets of a blurred surface move apart.
#pragma once

#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Per vertex the distance a sheet moves along the normal, metres; equal at equal positions. It is the blur, but
/// 0 at open rims and where boundary meets inner surface, and at most 0.4 of the radius of curvature on a side
/// towards which a sheet moves, so that no sheet folds over itself.
std::vector<float> sheet_distances(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normals);

}  // namespace pomona

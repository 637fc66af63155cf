// The distance by which the sheets of a blurred surface move apart.
#pragma once

#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Per vertex the distance by which a sheet moves along the normal, metres; equal at equal positions. It is the blur,
/// but 0 at open rims and where the boundary meets an inner surface. It is at most 0.4 times the radius of curvature on
/// the side to which the sheet moves, so that no sheet folds over itself.
std::vector<float> sheet_distances(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normals);

}  // namespace pomona

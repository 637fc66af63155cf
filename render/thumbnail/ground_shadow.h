// The shadow that pieces throw on the ground, softened.
#pragma once

#include <span>
#include <vector>

#include "render/export/styled_mesh.h"

namespace pomona {

/// How dark the ground y = 0 lies, 0 to 1, for each pixel of a square picture, row by row: the pieces' shadow in the
/// style's light, and below it a narrow one where they nearly touch the ground. Behind the pieces, too.
std::vector<float> ground_shadow(const Scene& scene, std::span<const StyledMesh> meshes, const Style& style, int side);

}  // namespace pomona

// What a round stand (bowl and ground) looks like from above, for the physics.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// (distance from the axis, height) of the upper surface from the axis outwards to `radius`, as few points as
/// keep within `tolerance`, metres. The mesh must be round about the axis and go on to `radius`.
std::vector<glm::dvec2> stand_profile(const TriangleTree& stand, double radius, double tolerance);

}  // namespace pomona

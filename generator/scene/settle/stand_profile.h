// The profile of a round stand (bowl and ground) seen from above, for the physics.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// Points (distance from the axis, height) of the upper surface, from the axis out to `radius`, metres: as few as keep
/// the error below `tolerance`, metres. The mesh must be round about the axis and reach as far as `radius`.
std::vector<glm::dvec2> stand_profile(const TriangleTree& stand, double radius, double tolerance);

}  // namespace pomona

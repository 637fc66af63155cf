// The boxes around a scene's pieces, and how far pieces shade the ground around them.
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "generator/mesh/box.h"
#include "generator/scene/scene.h"

namespace pomona {

/// A pose as a matrix.
glm::mat4 matrix_of(const Pose& pose);

/// The placed bounding boxes of all instances with vertices.
std::vector<Box<float>> placed_boxes(const Scene& scene);

/// How far from pieces the ground loses light of the sky: metres, six tenths of the pieces' mean height, or width if
/// that is less; 0 without pieces.
float sky_reach(const Scene& scene);

}  // namespace pomona

// Where a scene's pieces are, by the boxes around them: the ball around all, and how far they shade the ground.
#pragma once

#include <glm/mat4x4.hpp>

#include "generator/scene/scene.h"

namespace pomona {

/// A pose as a matrix.
glm::mat4 matrix_of(const Pose& pose);

/// A ball around all instances.
struct SceneBall {
  glm::vec3 center{0};
  float radius = 0;
};

SceneBall ball_around(const Scene& scene);

/// How far from pieces the ground loses light of the sky: metres, six tenths of the pieces' mean height, or width if
/// that is less; 0 without pieces.
float sky_reach(const Scene& scene);

}  // namespace pomona

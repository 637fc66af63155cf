// The axes about which a body turns without wobbling.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// A symmetric tensor is rotation * diagonal * rotation^T.
struct PrincipalAxes {
  glm::dvec3 moments{0};            ///< the diagonal, in the units of the tensor
  glm::dquat rotation{1, 0, 0, 0};  ///< from the axes to the frame of the tensor
};

/// The axes by Jacobi's rotations, which need only square roots: the same on every machine. A diagonal tensor keeps its
/// axes.
PrincipalAxes principal_axes(const glm::dmat3& tensor);

}  // namespace pomona

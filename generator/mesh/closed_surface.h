// A closed surface: a melon baller's ball, the offset of a skin, a level of a function.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A closed surface that does not cross itself. It separates the inside from the outside. Triangles run
/// counter-clockwise seen from outside.
struct ClosedSurface {
  std::vector<glm::dvec3> point;  ///< metres
  std::vector<glm::uvec3> triangle;
};

}  // namespace pomona

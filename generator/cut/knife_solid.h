// Knives that are no plane and no stroke: closed surfaces, such as a melon baller's ball or the offset of a skin.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A closed surface without crossings that parts what lies inside it from what lies outside. Triangles run
/// counter-clockwise seen from outside.
struct KnifeSolid {
  std::vector<glm::dvec3> point;  ///< metres, in the fruit's frame
  std::vector<glm::uvec3> triangle;
};

}  // namespace pomona

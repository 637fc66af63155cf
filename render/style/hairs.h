// Fuzz as single hairs, for pictures and exporters.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// A hair in the fruit's own frame, metres: from its root over its middle to its tip.
struct Hair {
  glm::vec3 root{0}, middle{0}, tip{0};
  glm::vec3 normal{0};  ///< unit normal of the skin at the root
  Color color{0};       ///< linear
};

/// The hairs on the parts of the skin that have fuzz; more than `max` are thinned out evenly. The same solid has the
/// same hairs. Hairs lean downwards and to all sides, as `lie` says.
std::vector<Hair> hairs_of(const Solid& solid, std::size_t max = 60000);

}  // namespace pomona

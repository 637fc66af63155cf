// A mark of a pen: a line or a dot.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

struct MarkPoint {
  glm::dvec2 at{0};   ///< pixels, y down
  double radius = 0;  ///< pixels
};

/// One point is a dot, several are a line whose width varies from each to the next.
using Mark = std::vector<MarkPoint>;

}  // namespace pomona

// A drawn stroke is a list of places, each with a radius.
#pragma once

#include <glm/vec2.hpp>

namespace pomona {

struct StrokePoint {
  glm::dvec2 at{0};
  double radius = 0;
  double opacity = 1;
};

/// Some of a picture's rows, the last not included.
struct PictureRows {
  int from = 0, to = 0;
};

}  // namespace pomona

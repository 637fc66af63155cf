// Lines on a solid's cut faces where the colour jumps from one side to the other.
#pragma once

#include <vector>

#include "generator/scene/solid.h"

namespace pomona {

struct InnerLine {
  glm::vec3 a{0}, b{0};
  float opacity = 1;  ///< grows with the jump
};

/// How opaque a line between two colours should be, from their distance in OKLab: those that one hardly tells
/// apart get none.
double line_opacity(double oklab_distance);

/// In the order of the solid's triangles.
std::vector<InnerLine> inner_lines(const Solid& solid);

}  // namespace pomona

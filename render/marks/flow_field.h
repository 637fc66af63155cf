// The flow field of a picture: directions along its edges.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/image/image.h"

namespace pomona {

/// A unit direction without a sign at each pixel, or each square of pixels, by rows from the top left.
struct FlowField {
  int width = 0, height = 0;  ///< squares
  std::vector<glm::vec2> direction;
  int square = 1;  ///< pixels each way

  /// The direction at the pixel of a place, or at the nearest pixel, with the sign nearer to `heading`.
  glm::dvec2 at(const glm::dvec2& place, const glm::dvec2& heading) const;
};

struct FlowOptions {
  double scale = 6;                  ///< pixels over which edges are gathered
  glm::dvec2 otherwise{0.82, 0.57};  ///< the direction where no edge is near
};

/// The minor directions of the picture's smoothed structure tensor, in OKLab [Kang et al. 2007, Kyprianidis and Kang
/// 2011]. Without edges nearby, farther ones count: the tensor is gathered over three widths, and wider ones have
/// smaller weights. Pictures of more than 1 600 pixels a side use squares of pixels.
FlowField flow_of(const Image& painted, const FlowOptions& options = {});

}  // namespace pomona

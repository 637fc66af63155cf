// The flow field of a picture: directions along its edges.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/image/image.h"

namespace pomona {

/// A direction without a sense at each pixel, or at each square of some, by rows from the top left; unit length.
struct FlowField {
  int width = 0, height = 0;  ///< squares
  std::vector<glm::vec2> direction;
  int square = 1;  ///< pixels each way

  /// At the pixel of a place, or at the nearest one, in the sense that is nearer to `heading`.
  glm::dvec2 at(const glm::dvec2& place, const glm::dvec2& heading) const;
};

struct FlowOptions {
  double scale = 6;                  ///< pixels over which edges are gathered
  glm::dvec2 otherwise{0.82, 0.57};  ///< where nothing runs any way for far around
};

/// The minor directions of the picture's smoothed structure tensor, in OKLab [Kang et al. 2007, Kyprianidis and Kang
/// 2011]. Where a place has no edges near, those farther away tell: the tensor is gathered over three widths, the wider
/// the weaker.
/// Pictures of more than 1 600 pixels a side are looked at in squares of several.
FlowField flow_of(const Image& painted, const FlowOptions& options = {});

}  // namespace pomona

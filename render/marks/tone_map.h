// The tone map of a picture: how dark each pixel is drawn.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/color.h"
#include "render/image/image.h"

namespace pomona {

struct ToneOptions {
  double blur = 1;        ///< pixels: grain and speckles finer than this have no tone of their own
  double bare = 0.05;     ///< darkness that still counts as paper, for its grain and brown edges
  double darkest = 0.96;  ///< share of the pixels that are not paper and stay below full ink
  bool stretched = true;  ///< if not, black alone is full ink
};

/// 0 = bare paper, 1 = full ink; by rows from the top left.
struct ToneMap {
  int width = 0, height = 0;
  std::vector<float> darkness;

  /// The darkness at a place in pixels; 0 outside of the picture.
  double at(const glm::dvec2& place) const;
};

/// How much less light each pixel has than the paper (OKLab lightness), blurred, and stretched so that the darkest
/// tones of the picture become full ink: a pale fruit is drawn with as much contrast as a dark one.
ToneMap tones_of(const Image& painted, const Color& paper, const ToneOptions& options = {});

}  // namespace pomona

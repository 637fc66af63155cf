// The paper everything is drawn on.
#pragma once

#include "generator/base/color.h"

namespace pomona {

/// A sheet of one colour with a grain: tooth and fibres a few pixels long, `grain` deep in OKLab lightness. Tied
/// to pixels: a larger picture is a larger sheet. The grain is mirrored in shaders/paper.glsl.
class Paper {
 public:
  Paper(const Color& color, double grain);

  /// Without grain the colour itself.
  Color at(int x, int y) const;

 private:
  Color color_;
  glm::vec3 lab_;
  double grain_;
};

}  // namespace pomona

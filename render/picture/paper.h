// The paper on which everything is drawn, and the paint on it.
#pragma once

#include "generator/base/color.h"
#include "render/style/paint.h"
#include "render/style/style.h"

namespace pomona {

/// A sheet of the style's paper: its colour, a grain with fibres a few pixels long, and brown edges. The grain has a
/// fixed size in pixels: a larger picture is a larger sheet. The same code is in shaders/paper.glsl.
class Paper {
 public:
  Paper(const Style& style, int width, int height);

  /// The colour of the paper at a pixel. Without grain and vignette it is the style's colour.
  Color at(int x, int y) const;

  /// A colour as paint on this paper, with the style's saturation, lightness and granulation. If the style has none of
  /// these, the colour keeps its bits.
  Color painted(const Color& color, int x, int y) const;

 private:
  double grain_at(int x, int y) const;
  double age_at(int x, int y) const;

  Color color_;
  glm::vec3 lab_;
  Paint paint_;
  double grain_, vignette_, granulation_;
  double width_, height_;
};

}  // namespace pomona

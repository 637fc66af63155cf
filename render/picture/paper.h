// The paper everything is drawn on, and the paint on it.
#pragma once

#include "generator/base/color.h"
#include "render/style/paint.h"
#include "render/style/style.h"

namespace pomona {

/// A sheet of the style's paper: its colour, a grain of tooth and fibres a few pixels long, and edges that have gone
/// brown. The grain is tied to pixels: a larger picture is a larger sheet. Mirrored in shaders/paper.glsl.
class Paper {
 public:
  Paper(const Style& style, int width, int height);

  /// With neither grain nor vignette the colour itself.
  Color at(int x, int y) const;

  /// What a colour becomes as paint on this paper: the style's saturation, lightness and granulation. The colour
  /// itself, bit for bit, where the style asks for none of them.
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

// A style's saturation and lightness, for all painted colours: on paper, in textures, at vertices.
#pragma once

#include "generator/base/color.h"
#include "render/style/style.h"

namespace pomona {

class Paint {
 public:
  explicit Paint(const Style& style) : saturation_(style.saturation), lightness_(style.lightness) {}

  /// The colour with the style's saturation and lightness.
  /// \param lift further lightness, OKLab. Without any change it returns the colour bit for bit.
  Color operator()(const Color& color, double lift = 0) const;

  /// Whether it changes no colour.
  bool is_plain() const { return saturation_ == 1 && lightness_ == 0; }

 private:
  double saturation_, lightness_;
};

}  // namespace pomona

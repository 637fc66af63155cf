// What a style does to colours that are painted, wherever they end up: on paper, in a texture, at a vertex.
#pragma once

#include "generator/base/color.h"
#include "render/style/style.h"

namespace pomona {

class Paint {
 public:
  explicit Paint(const Style& style) : saturation_(style.saturation), lightness_(style.lightness) {}

  /// The colour with the style's saturation and lightness. \param lift added lightness on top, OKLab. The colour
  /// itself, bit for bit, where nothing is asked for.
  Color operator()(const Color& color, double lift = 0) const;

  /// Whether it leaves all colours alone.
  bool is_plain() const { return saturation_ == 1 && lightness_ == 0; }

 private:
  double saturation_, lightness_;
};

}  // namespace pomona

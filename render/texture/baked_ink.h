// Ink on the cut faces of a texture, drawn with the same pen as in pictures of sections.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/picture/stroke.h"
#include "render/style/style.h"
#include "render/texture/uv_atlas.h"

namespace pomona {

/// The lines on one chart.
struct BakedInk {
  InkLayer rim, inner;
  glm::ivec2 low{0};  ///< the texel of the atlas at which the layers begin
  Color ink{0};
  double inner_opacity = 0;

  /// The texel's colour (linear) under its ink.
  Color over(const Color& color, int x, int y) const;
};

/// The ink of a chart that is part of a cut face. Widths are as in a picture that the solid's largest cut face fills.
BakedInk baked_ink(const Solid& solid, const std::vector<Chart>& charts, std::size_t chart, const Atlas& atlas,
                   const Style& style);

}  // namespace pomona

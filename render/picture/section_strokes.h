// The pen strokes of a section's picture.
#pragma once

#include "generator/cut/section/cross_section.h"
#include "generator/template/template.h"
#include "render/picture/section_layout.h"
#include "render/picture/stroke.h"
#include "render/style/style.h"

namespace pomona {

struct SectionStroke {
  std::vector<StrokePoint> points;  ///< pixels
  int face = 0;
  bool rim = false;
};

/// The strokes in the order of section_lines(). Widths are those of the style times those of the ink; small faces and
/// short lines get thinner strokes. \param side the picture's shorter side, pixels.
std::vector<SectionStroke> section_strokes(const CrossSection& section, const std::vector<PlacedFace>& faces,
                                           const InkStyle& ink, const Style& style, double side);

}  // namespace pomona

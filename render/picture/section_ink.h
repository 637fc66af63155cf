// The lines of a cross-section that are drawn in ink.
#pragma once

#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/picture/section_layout.h"
#include "render/picture/stroke.h"

namespace pomona {

/// A line on the paper: the rim of a face, or an inner cut segment where the colour changes. A larger change gives a
/// more opaque line.
struct SectionLine {
  PenLine line;
  int face = 0;
  bool rim = false;
};

std::vector<SectionLine> section_lines(const CrossSection& section, const std::vector<PlacedFace>& faces);

}  // namespace pomona

// Which lines of a cross-section are worth ink.
#pragma once

#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/picture/section_layout.h"
#include "render/picture/stroke.h"

namespace pomona {

/// A line on the paper, along the rim of a face or along an inner cut segment where the colour jumps (the more
/// it jumps, the more opaque).
struct SectionLine {
  PenLine line;
  int face = 0;
  bool rim = false;
};

std::vector<SectionLine> section_lines(const CrossSection& section, const std::vector<PlacedFace>& faces);

}  // namespace pomona

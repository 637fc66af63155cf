// Which part of the fruit each pixel of a section's picture shows.
#pragma once

#include <vector>

#include "generator/cut/cross_section.h"
#include "render/picture/section_layout.h"
#include "render/plate/part_map.h"

namespace pomona {

/// Looked at in the middle of each pixel: the part of the triangle's vertex with the largest share there.
PartMap section_parts(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height);

/// Names of the parts that the section's vertices bear.
std::vector<std::string> parts_in(const CrossSection& section);

}  // namespace pomona

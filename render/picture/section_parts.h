// The part of the fruit in each pixel of a section's picture.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/picture/section_layout.h"
#include "render/plate/part_map.h"

namespace pomona {

/// The part at the middle of each pixel: that of the triangle's vertex with the largest barycentric coordinate.
PartMap section_parts(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height);

/// The part on the outside of a surface: name of the surface -> name of the part.
using OutsideParts = std::map<std::string, std::string>;

/// Adds the parts that appear only as a rim of the section, such as a skin without thickness: a part gets the pixels of
/// its rim if fewer pixels show it otherwise.
void add_rims(PartMap& map, const CrossSection& section, const std::vector<PlacedFace>& faces,
              const OutsideParts& outside);

/// Names of the parts of the section's vertices, and of the parts outside along its rim.
std::vector<std::string> parts_in(const CrossSection& section, const OutsideParts& outside = {});

}  // namespace pomona

// Which part of the fruit each pixel of a section's picture shows.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/picture/section_layout.h"
#include "render/plate/part_map.h"

namespace pomona {

/// Looked at in the middle of each pixel: the part of the triangle's vertex with the largest share there.
PartMap section_parts(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height);

/// Which part the outside of a surface is: by the surface's name, the part's.
using OutsideParts = std::map<std::string, std::string>;

/// Adds the parts that a section shows as its rim alone, such as a skin without thickness: those that fewer pixels
/// show than there are along the rim have these.
void add_rims(PartMap& map, const CrossSection& section, const std::vector<PlacedFace>& faces,
              const OutsideParts& outside);

/// Names of the parts that the section's vertices bear, and of those that are outside along its rim.
std::vector<std::string> parts_in(const CrossSection& section, const OutsideParts& outside = {});

}  // namespace pomona

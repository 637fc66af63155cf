// How a picture or a page fits into a box of another shape: SVG's preserveAspectRatio.
#pragma once

#include <string_view>

#include <glm/vec2.hpp>

namespace pomona {

struct SvgAspect {
  bool stretches = false;  ///< "none": it fills the box, whatever becomes of its shape
  bool slices = false;     ///< it covers the box, and parts of it lie outside; else it lies in the box
  glm::dvec2 align{0.5};   ///< where the room that is left lies before it: none of it, half, all
};

/// As SVG 1.1 says (section 7.8); what is written otherwise counts for nothing there.
SvgAspect parse_svg_aspect(std::string_view text);

}  // namespace pomona

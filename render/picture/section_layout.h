// The layout of cut faces on the paper.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/cut/section/cross_section.h"

namespace pomona {

/// The map of a face from the fruit to the paper and back. Paper coordinates are pixels, y down.
struct PlacedFace {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0};  ///< unit vectors within the face
  glm::dvec3 depth{0};                     ///< offset of the face along its normal
  glm::dvec2 low{0}, high{0};              ///< bounds along right and up, metres
  glm::dvec2 corner{0};                    ///< position of the bounds' upper left corner on the paper
  double scale = 1;                        ///< pixels per metre
  bool shown = false;                      ///< it has triangles
  double shift = 0;                        ///< shift of a stroke's facet along `right` when unrolled, metres

  glm::dvec2 to_paper(const glm::dvec3& p) const;
  glm::dvec3 to_fruit(const glm::dvec2& pixel) const;
};

/// The map of each face of the section. Faces are in rows, in cut order; the common scale fills the picture best.
std::vector<PlacedFace> lay_out(const CrossSection& section, const glm::dvec2& picture, double gap);

}  // namespace pomona

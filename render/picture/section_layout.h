// Where each cut face goes on the paper.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/cut/section/cross_section.h"

namespace pomona {

/// A face's way from the fruit to the paper and back. Pixels, y down.
struct PlacedFace {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0};  ///< unit vectors within the face
  glm::dvec3 depth{0};                     ///< what the two do not say of a point: its share along the normal
  glm::dvec2 low{0}, high{0};              ///< bounds along right and up, metres
  glm::dvec2 corner{0};                    ///< where the upper left of the bounds goes
  double scale = 1;                        ///< pixels per metre
  bool shown = false;                      ///< it has triangles
  double shift = 0;                        ///< of a stroke's facet, along right: metres to its place when unrolled

  glm::dvec2 to_paper(const glm::dvec3& p) const;
  glm::dvec3 to_fruit(const glm::dvec2& pixel) const;
};

/// One per face of the section, in rows in cut order, at the one scale that fills the picture best.
std::vector<PlacedFace> lay_out(const CrossSection& section, const glm::dvec2& picture, double gap);

}  // namespace pomona

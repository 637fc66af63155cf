// Labels beside a figure, each with a line to its part.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "render/plate/part_map.h"

namespace pomona {

/// Pixels, y down.
struct PlateBox {
  glm::dvec2 low{0}, high{0};
};

/// A word on the base line at `start`, and the line from it to the part.
struct Label {
  std::string text;
  std::int32_t part = 0;
  glm::dvec2 start{0};
  PlateBox bounds;       ///< bounds of the word
  glm::dvec2 leader{0};  ///< start of the line at the word
  glm::dvec2 tip{0};     ///< end of the line, inside the part
  bool left = false;     ///< whether the word is left of the figure
};

struct LabelWish {
  ShownPart part;
  std::string text;
  double width = 0;  ///< width of the word, pixels
};

/// Words stacked left and right of the figure, each at one height. Lines do not cross and words do not overlap; if they
/// do not fit at 1.15 ems apart, those of the smallest parts are left out.
/// \param figure the box that words avoid; they keep `gap` beside it
std::vector<Label> placed_labels(std::vector<LabelWish> wishes, const PlateBox& figure, double em, double gap);

/// Whether the lines from leader to tip cross.
bool leaders_cross(const Label& a, const Label& b);

}  // namespace pomona

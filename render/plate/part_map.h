// The part of the fruit in each pixel of a picture, and the best points for labels.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

struct PartMap {
  int width = 0, height = 0;
  std::vector<std::int32_t> part;  ///< per pixel, row by row from the top left: index into names, -1 = none
  std::vector<std::string> names;

  std::int32_t at(int x, int y) const { return part[static_cast<std::size_t>(y) * width + x]; }
};

/// A part that is visible enough to be named.
struct ShownPart {
  std::int32_t part = 0;
  double area = 0;  ///< pixels
  /// Possible end points of a label's line, pixels: points well inside the part, from left to right.
  std::vector<glm::dvec2> places;
};

/// All parts that cover at least `min_share` of the figure and are somewhere at least `min_depth` pixels thick to
/// either side, in the order of their numbers; thinner ones only at the figure's rim, with places on it. Parts of one
/// name are one.
std::vector<ShownPart> shown_parts(const PartMap& map, double min_share, double min_depth);

}  // namespace pomona

// The picture of a texture by example: a small cube of flesh whose opposite faces fit together.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"

namespace pomona {

/// The tile at one fineness.
struct TileLevel {
  int side = 1;              ///< texels along each edge
  std::vector<Color> color;  ///< linear light; texel (x, y, z) at (z * side + y) * side + x
};

/// Variants share it.
struct ExampleTile {
  std::string path;                   ///< path of its file, for messages
  std::vector<glm::u8vec3> texel;     ///< as in the file, sRGB
  std::vector<TileLevel> levels;      ///< from the file's own to the mean alone; each has that mean
  Color lowest{0}, highest{0};        ///< least and most of each channel
  double darkest = 0, brightest = 0;  ///< least and most of the texels' luminance

  int side() const { return levels.front().side; }
  const Color& mean() const { return levels.back().color.front(); }
};

/// Prepares a cube of side * side * side texels. The side is a multiple of 16, so that four levels halve evenly; those
/// above are the mean of what is left.
ExampleTile example_tile(const std::string& path, int side, std::vector<glm::u8vec3> texel);

}  // namespace pomona

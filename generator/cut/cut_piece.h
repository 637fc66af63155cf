// What a cut leaves of a fruit: one piece of it, its cut faces still without colours.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"

namespace pomona {

/// A piece before its cut faces have colours: which skin it keeps, and which triangles of the section.
/// Vertices lie exactly where those of the section lie, so the piece closes by position.
struct CutPiece {
  // Skin and cavity walls, clipped. Triangles face air. Colours, parts are those of the hidden (air) side.
  std::vector<glm::vec3> position;
  std::vector<glm::vec3> normal;  ///< smooth, pointing to air
  std::vector<Color> color;
  std::vector<std::int32_t> part;   ///< per vertex; index into CrossSection::part_names
  std::vector<std::uint8_t> bared;  ///< per vertex: 1 on the wall of what knives went around: as new to air as a face
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> surface;  ///< per triangle

  struct CapTriangle {
    std::uint32_t triangle = 0;  ///< of the section
    bool reversed = false;       ///< the piece lies on the positive side: it faces against the face's normal
  };
  std::vector<CapTriangle> caps;

  double volume = 0;  ///< cubic metres, bodies summed
  bool closed = true;
  bool crumb = false;
};

}  // namespace pomona

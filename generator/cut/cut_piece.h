// What a cut leaves of a fruit: one piece of it, its cut faces still without colours.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"

namespace pomona {

/// A piece before its cut faces have colours: its part of the skin, and its triangles of the section.
/// Vertices lie exactly where those of the section lie, so the piece closes by position.
struct CutPiece {
  // Skin and cavity walls, clipped. Triangles face air. Colours, parts are those of the hidden (air) side.
  std::vector<glm::vec3> position;
  std::vector<glm::vec3> normal;  ///< smooth, pointing to air
  std::vector<Color> color;
  std::vector<std::int32_t> part;   ///< per vertex; index into CrossSection::part_names
  std::vector<std::uint8_t> bared;  ///< per vertex: 1 on the wall of a spared part: freshly exposed, as a cut face is
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> surface;   ///< per triangle
  std::vector<std::int32_t> instance;  ///< per triangle (DiffusionSurfaces::instance); empty where nothing is placed

  /// The instances of placed templates whose skin it has (DiffusionSurfaces::instance), ascending; empty where nothing
  /// is placed.
  std::vector<std::int32_t> instances;

  struct CapTriangle {
    std::uint32_t triangle = 0;  ///< of the section
    bool reversed = false;       ///< the piece lies on the positive side, so that its triangle faces against the normal
  };
  std::vector<CapTriangle> caps;

  double volume = 0;  ///< cubic metres, the sum over bodies
  bool closed = true;
  bool crumb = false;
};

}  // namespace pomona

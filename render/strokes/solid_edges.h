// The edges of a solid that can become lines, from any viewpoint.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/piece/solid.h"

namespace pomona {

enum class LineKind : std::uint8_t {
  contour,  ///< where a smooth surface turns away from the eye
  border,   ///< of an open surface
  rim,      ///< where a cut face meets the skin; faint where the rim of one body is inside another
  ridge,    ///< where two cut faces meet
  crease,   ///< a sharp edge of the skin
  seam,     ///< where two surfaces of the skin meet
  fold,     ///< an edge that is a line only if one of its faces faces away
  inner,    ///< on a cut face, where the colour jumps
};

/// Drawn with the finer pen.
constexpr bool is_inner(LineKind kind) {
  return kind == LineKind::crease || kind == LineKind::seam || kind == LineKind::inner;
}

struct SharpEdge {
  std::uint32_t a = 0, b = 0;          ///< places
  std::uint32_t first = 0, other = 0;  ///< the triangles that meet there; the same twice on a border
  LineKind kind = LineKind::border;
  float opacity = 1;
};

struct SolidEdges {
  std::vector<std::uint32_t> place;   ///< per vertex: the first vertex with the same position
  std::vector<std::uint32_t> smooth;  ///< per vertex: the first vertex with the same position and normal
  std::vector<SharpEdge> sharp;       ///< in the order of their positions
};

/// Two triangles meet in an edge when its ends lie at equal positions. Creases are those where the surface turns by
/// more than 60 degrees.
SolidEdges solid_edges(const Solid& solid);

}  // namespace pomona

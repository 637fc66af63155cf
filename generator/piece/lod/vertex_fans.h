// A solid's triangles, prepared for a half-edge structure, which allows two triangles per edge and one fan per vertex.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// A fan is a vertex of the half-edge mesh: triangles around one point that are connected by edges. Where bodies of a
/// solid touch, a point has several fans.
struct VertexFans {
  std::vector<glm::uvec3> triangle;  ///< fans at the corners
  std::vector<std::uint32_t>
      twin;  ///< per edge 3 t + i of triangle t: the one that runs back; the largest number: none
  std::vector<std::uint32_t> source;    ///< per triangle: which one of the solid it is, ascending
  std::vector<std::uint32_t> vertex;    ///< per fan: a vertex of the solid at its place
  std::vector<std::uint8_t> is_locked;  ///< per fan: 1 where it must stay: beside another fan or a frozen triangle
  std::vector<std::uint32_t> frozen;    ///< triangles of the solid at edges that more than two share
};

/// Triangles with two equal corners are in neither list. A closed solid stays closed whatever happens to fans that are
/// not locked, because an edge between a frozen triangle and another one keeps both ends.
VertexFans vertex_fans(const Solid& solid);

}  // namespace pomona
